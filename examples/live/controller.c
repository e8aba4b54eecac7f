/* SPDX-License-Identifier: Apache-2.0 */

/* A finger strokes the skin at 1 kHz, and the controller reads the electrode: time, normal force and current of every
   tenth step.

     cc controller.c -lionskin_live -o controller && ./controller skin.live */

#include <ionskin_live.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char** argv) {
  char message[1000];
  ionskin_live_skin* skin = argc == 2 ? ionskin_live_open(argv[1], message, sizeof message) : NULL;
  if (skin == NULL) {
    fprintf(stderr, "%s\n", argc == 2 ? message : "usage: controller skin.live");
    return 2;
  }
  size_t force = 0, current = 0;
  const size_t count = ionskin_live_signal_count(skin);
  for (size_t i = 0; i < count; ++i) {
    force = strcmp(ionskin_live_signal_name(skin, i), "normal_force") == 0 ? i : force;
    current = strcmp(ionskin_live_signal_name(skin, i), "current_top") == 0 ? i : current;
  }
  double range[7], *signals = malloc(count * sizeof *signals);
  if (signals == NULL) {
    ionskin_live_close(skin);
    return 1;
  }
  ionskin_live_range(skin, range);
  for (int i = 0; i <= 1000; ++i) {
    const double time = 1e-3 * i, way = (range[2] - range[0]) * time / 2;
    const uint32_t flags = ionskin_live_step(skin, time, range[0] + way, range[1], IONSKIN_LIVE_HEIGHT,
                                             -range[5] / 2, signals);
    if (i % 10 == 0) {
      printf("%g,%g,%g,%u\n", time, signals[force], signals[current], flags);
    }
  }
  free(signals);
  ionskin_live_close(skin);
  return 0;
}
