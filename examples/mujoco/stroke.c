/* SPDX-License-Identifier: Apache-2.0 */

/* A finger strokes an ionic skin in MuJoCo: a sensor callback steps the live skin with the contact that MuJoCo finds.
   MuJoCo knows the skin as a rigid body; the live skin tells what that contact does to it. Prints a table:

     cc stroke.c -lmujoco -lionskin_live -lm -o stroke && ./stroke finger.xml skin.live > stroke.csv */

#include <ionskin_live.h>
#include <mujoco/mujoco.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the callback knows; MuJoCo has one for all models. */
static struct {
  ionskin_live_skin* skin;
  double* signals;
  int* signal_of_sensor; /* -1: none of ours */
  int site, skin_geom, finger_geom;
  double last_time;
  uint32_t flags; /* of all steps */
} ours;

static double contact_force(const mjModel* model, const mjData* data) {
  double sum = 0;
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact* contact = &data->contact[i];
    if ((contact->geom1 == ours.skin_geom && contact->geom2 == ours.finger_geom) ||
        (contact->geom1 == ours.finger_geom && contact->geom2 == ours.skin_geom)) {
      mjtNum force[6];
      mj_contactForce(model, data, i, force);
      sum += force[0]; /* along the normal */
    }
  }
  return sum;
}

static void feel(const mjModel* model, mjData* data, int stage) {
  if (stage != mjSTAGE_ACC) {
    return;
  }
  if (data->time < ours.last_time) { /* the simulation was reset */
    ionskin_live_reset(ours.skin);
  }
  if (data->time != ours.last_time) { /* some integrators ask more than once */
    ours.last_time = data->time;
    mjtNum away[3], place[3];
    mju_sub3(away, data->geom_xpos + 3 * ours.finger_geom, data->site_xpos + 3 * ours.site);
    mju_rotVecMatT(place, away, data->site_xmat + 9 * ours.site);
    ours.flags |= ionskin_live_step(ours.skin, data->time, place[0], place[1], IONSKIN_LIVE_FORCE,
                                    contact_force(model, data), ours.signals);
  }
  for (int i = 0; i < model->nsensor; ++i) {
    if (ours.signal_of_sensor[i] >= 0) {
      data->sensordata[model->sensor_adr[i]] = ours.signals[ours.signal_of_sensor[i]];
    }
  }
}

static int find_signals(const mjModel* model) {
  const int count = (int)ionskin_live_signal_count(ours.skin);
  for (int i = 0; i < model->nsensor; ++i) {
    ours.signal_of_sensor[i] = -1;
    if (model->sensor_type[i] == mjSENS_USER) {
      const char* name = mj_id2name(model, mjOBJ_SENSOR, i);
      for (int j = 0; j < count && name != NULL; ++j) {
        if (strcmp(name, ionskin_live_signal_name(ours.skin, (size_t)j)) == 0) {
          ours.signal_of_sensor[i] = j;
        }
      }
      if (ours.signal_of_sensor[i] < 0) {
        fprintf(stderr, "the skin has no signal %s\n", name == NULL ? "" : name);
        return 0;
      }
    }
  }
  return 1;
}

/* Smoothly from 0 to 1. */
static double ramp(double time, double begin, double end) {
  const double share = fmin(fmax((time - begin) / (end - begin), 0), 1);
  return share * share * (3 - 2 * share);
}

int main(int argc, char** argv) {
  char message[1000];
  if (argc != 3) {
    fprintf(stderr, "usage: stroke finger.xml skin.live\n");
    return 2;
  }
  ours.skin = ionskin_live_open(argv[2], message, sizeof message);
  mjModel* model = ours.skin == NULL ? NULL : mj_loadXML(argv[1], NULL, message, sizeof message);
  if (model == NULL) {
    fprintf(stderr, "%s\n", message);
    return 2;
  }
  mjData* data = mj_makeData(model);
  ours.signals = calloc(ionskin_live_signal_count(ours.skin), sizeof *ours.signals);
  ours.signal_of_sensor = calloc((size_t)model->nsensor + 1, sizeof *ours.signal_of_sensor);
  ours.site = mj_name2id(model, mjOBJ_SITE, "skin");
  ours.skin_geom = mj_name2id(model, mjOBJ_GEOM, "skin");
  ours.finger_geom = mj_name2id(model, mjOBJ_GEOM, "finger");
  ours.last_time = -1;
  if (data == NULL || ours.signals == NULL || ours.signal_of_sensor == NULL || !find_signals(model)) {
    return 1;
  }
  mjcb_sensor = feel;

  /* Press, stroke over the trained places at half the trained speed, lift. */
  double range[7];
  ionskin_live_range(ours.skin, range);
  const double press = 0.4 * range[4], way = range[2] - range[0];
  const double begin = 0.6, end = begin + way / (range[6] / 2), last = end + 0.4;
  data->qpos[0] = data->ctrl[0] = range[0];
  data->qpos[1] = data->ctrl[1] = range[1];
  data->qpos[2] = 2e-4; /* above the skin */
  printf("time [s],x [m],contact_force [N]");
  for (int i = 0; i < model->nsensor; ++i) {
    const char* name = mj_id2name(model, mjOBJ_SENSOR, i);
    printf(",%s%s", name, strstr(name, "current") ? " [A]" : strstr(name, "force") ? " [N]" : "");
  }
  printf("\n");
  while (data->time < last) {
    data->ctrl[0] = range[0] + way * ramp(data->time, begin, end);
    data->ctrl[2] = -press * (0.05 + 0.95 * ramp(data->time, 0.2, 0.5)) * (1 - ramp(data->time, end, end + 0.2)) +
                    0.1 * press * ramp(data->time, end + 0.2, last);
    mj_step(model, data);
    printf("%.4f,%.9g,%.9g", ours.last_time, ours.signals[0], contact_force(model, data));
    for (int i = 0; i < model->nsensor; ++i) {
      printf(",%.9g", data->sensordata[model->sensor_adr[i]]);
    }
    printf("\n");
  }
  if (ours.flags != 0) {
    fprintf(stderr, "steps outside the trained range, or not converged: flags %u\n", (unsigned)ours.flags);
  }
  mj_deleteData(data);
  mj_deleteModel(model);
  ionskin_live_close(ours.skin);
  free(ours.signals);
  free(ours.signal_of_sensor);
  return 0;
}
