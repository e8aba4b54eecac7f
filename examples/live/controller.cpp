// SPDX-License-Identifier: Apache-2.0

// A controller in C++: a finger strokes the skin at 1 kHz under a force. Before each step it asks
// what the current would be if the finger pressed a tenth harder, and goes back. Prints time,
// normal force, current, the flags, and that other current, of every tenth step.

#include <ionskin_live.hpp>

#include <cstdio>
#include <exception>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: controller skin.live\n");
    return 2;
  }
  try {
    ionskin_live::Skin skin(argv[1]);
    const std::size_t force = skin.index("normal_force"), current = skin.index("current_top");
    const std::array<double, 7> range = skin.range();
    const double low_x = range[0], low_y = range[1], high_x = range[2], heaviest = range[4];
    std::vector<double> state(skin.state_size());
    for (int i = 0; i <= 1000; ++i) {
      const double time = 1e-3 * i, x = low_x + (high_x - low_x) * time / 2;
      skin.save(state.data());
      const double harder =
          skin.step(time, {x, low_y}, ionskin_live::Force{0.55 * heaviest})[current];
      skin.restore(state.data(), state.size());
      const ionskin_live::Signals& signals =
          skin.step(time, {x, low_y}, ionskin_live::Force{heaviest / 2});
      if (i % 10 == 0) {
        std::printf("%g,%g,%g,%u,%g\n", time, signals[force], signals[current], signals.flags,
                    harder);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
