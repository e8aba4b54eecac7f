/* SPDX-License-Identifier: Apache-2.0 */
#ifndef IONSKIN_LIVE_H
#define IONSKIN_LIVE_H

/* The reduced skin for programs in C and whatever calls it. SI units. Within one number of the
   interface functions are only added. A skin belongs to one thread at a time; skins of one file
   share its data. `step`, `run`, `save`, `restore` and `reset` allocate nothing and always return.
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define IONSKIN_LIVE_INTERFACE 1

/* Bits of what a step returns; 0 where all is well. */
#define IONSKIN_LIVE_OUTSIDE_PLACE 1u /* taken to the nearest trained place */
#define IONSKIN_LIVE_OUTSIDE_LOAD                                                                  \
  2u /* heavier or deeper than trained: the heaviest or deepest was taken */
#define IONSKIN_LIVE_OUTSIDE_SPEED 4u /* faster than trained */
#define IONSKIN_LIVE_UNCONVERGED 8u   /* residual above 1e-3 */
#define IONSKIN_LIVE_REFUSED 16u      /* NaN, infinity or a time before the last: nothing moved */
#define IONSKIN_LIVE_PULLED 32u       /* a negative force: detached, as with none */
/* steeper than trained, or turned about z where the underside does not turn into itself: the
   nearest tilt, or no turn, was taken */
#define IONSKIN_LIVE_OUTSIDE_POSE 64u

enum { IONSKIN_LIVE_HEIGHT = 0, IONSKIN_LIVE_FORCE = 1 };

typedef struct ionskin_live_skin ionskin_live_skin;

/* Number of the interface that the library has. */
uint32_t ionskin_live_interface(void);

/* NULL when the file cannot be used; why stands in `message` then, cut to `size` bytes. */
ionskin_live_skin* ionskin_live_open(const char* path, char* message, size_t size);
/* Another skin of the same file in the same state; NULL without memory. */
ionskin_live_skin* ionskin_live_copy(const ionskin_live_skin* skin);
void ionskin_live_close(ionskin_live_skin* skin);

size_t ionskin_live_signal_count(const ionskin_live_skin* skin);
/* As in signals.csv and taxels.csv; NULL behind the last. */
const char* ionskin_live_signal_name(const ionskin_live_skin* skin, size_t signal);

/* time [s]; x, y of the slider's centre [m]; `value` is the height of the underside above the
   undeformed top face [m], negative when it indents, or the normal force [N], as `kind` says.
   `signals` takes signal_count values. */
uint32_t ionskin_live_step(ionskin_live_skin* skin, double time, double x, double y, int kind,
                           double value, double* signals);
/* The same of a slider that is tilted and turned: roll, pitch and yaw [rad], as slider.roll and the
   others of a case. `height` is that of its lowest point. `step` is that of angles 0. */
uint32_t ionskin_live_step_posed(ionskin_live_skin* skin, double time, double x, double y,
                                 const double angles[3], int kind, double value, double* signals);
/* Many steps: positions [count][2], signals [count][signal_count], flags [count]. */
void ionskin_live_run(ionskin_live_skin* skin, size_t count, const double* times,
                      const double* positions, int kind, const double* values, double* signals,
                      uint32_t* flags);

/* Derivative of the last step's wrench on the skin by a rigid motion of the slider, row by row: the
   forces along x, y and z [N] and the moments about x, y and z [N m], by ways along x, y and z [m]
   and turns about x, y and z through the slider's centre on the undeformed top face [rad], while
   the step begins as it did. Takes no memory. 1; or 0, and NaN, before the first step and behind
   `restore` and `reset`, or where it was not found. Of a skin that is computed as one half, what is
   not alike on both halves is NaN: ways along y, turns about x and z. */
int ionskin_live_stiffness(ionskin_live_skin* skin, double stiffness[36]);

/* Charges among the signals: those of top and bottom and of the taxels. */
size_t ionskin_live_charge_count(const ionskin_live_skin* skin);
/* Derivatives of the last step's charges by such a motion, [charge_count][6], in C/m and C/rad: of
   the signals whose names begin with charge_, in their order. Takes no memory. 1; or 0, and NaN,
   as `ionskin_live_stiffness`, which also says what is NaN of a skin that is computed as one half.
 */
int ionskin_live_charge_derivatives(ionskin_live_skin* skin, double* derivatives);

/* Many steps, with angles [count][3]. */
void ionskin_live_run_posed(ionskin_live_skin* skin, size_t count, const double* times,
                            const double* positions, const double* angles, int kind,
                            const double* values, double* signals, uint32_t* flags);

size_t ionskin_live_state_size(const ionskin_live_skin* skin); /* numbers */
void ionskin_live_save(const ionskin_live_skin* skin, double* state);
/* 1, or 0 when it is not a state of this skin: the size is another, or a number is not finite or
   beyond what a step can leave; nothing changes then. */
int ionskin_live_restore(ionskin_live_skin* skin, const double* state, size_t size);
/* Back to a detached skin at rest. */
void ionskin_live_reset(ionskin_live_skin* skin);

/* Another coefficient of friction, which is not part of the state; takes memory. 1, or 0 when it is
   outside the trained range; nothing changes then. */
int ionskin_live_set_friction(ionskin_live_skin* skin, double coefficient);
/* The present coefficient of friction, the lowest and the highest that were trained. */
void ionskin_live_friction(const ionskin_live_skin* skin, double friction[3]);

/* "case", "version" or "command" of the training; "shortfall": one line on the events whose errors
   are larger than promised, empty without; NULL for another word. */
const char* ionskin_live_text(const ionskin_live_skin* skin, const char* what);
/* Trained: lowest x, y, highest x, y [m], force [N], indentation [m], speed [m/s]. */
void ionskin_live_range(const ionskin_live_skin* skin, double range[7]);
/* Trained: tilt [rad] and turn about z [rad/s], 0 for none; and 1 if the underside turns into
   itself about z, else 0. */
void ionskin_live_pose_range(const ionskin_live_skin* skin, double range[3]);
/* Length and width of the skin [m]. */
void ionskin_live_size(const ionskin_live_skin* skin, double size[2]);
/* Lowest x, y, highest x, y of the contact cells, from the slider's centre [m]: nothing beyond them
   touches. */
void ionskin_live_footprint(const ionskin_live_skin* skin, double box[4]);
/* Thickness of the core [m]. */
double ionskin_live_core_thickness(const ionskin_live_skin* skin);
/* Lowest x, y, highest x, y of a taxel [m]; 0 behind the last. */
int ionskin_live_taxel(const ionskin_live_skin* skin, size_t index, const char** name,
                       double corners[4]);
/* Error of a signal on touches that it was not trained on; 0 behind the last. */
int ionskin_live_error(const ionskin_live_skin* skin, size_t index, const char** name, double* rms,
                       double* worst, double* largest);

/* The same with the event of the touches over which it is taken: "landing", "slip_onset", "hold" or
   "lift". Errors over whole touches come first, with an empty event. 0 behind the last. */
int ionskin_live_event_error(const ionskin_live_skin* skin, size_t index, const char** event,
                             const char** name, double* rms, double* worst, double* largest);

/* Many skins of one file, the environments of a learner, stepped together. What one of them does
   depends neither on the others nor on which worker steps it. */
typedef struct ionskin_live_skins ionskin_live_skins;

/* What a step takes and gives, for all environments. `single` says that positions, values and
   signals are floats; else they are doubles. */
typedef struct ionskin_live_batch {
  const double* times;     /* [environment] */
  const void* positions;   /* [environment][x, y] */
  const void* values;      /* [environment] */
  void* signals;           /* [environment][column] */
  uint32_t* flags;         /* [environment] */
  const uint32_t* columns; /* signals that are written [column_count] */
  size_t column_count;
  int kind; /* IONSKIN_LIVE_HEIGHT or IONSKIN_LIVE_FORCE */
  int single;
} ionskin_live_batch;

/* All in the state and with the friction of `like`, without noise; NULL without memory. */
ionskin_live_skins* ionskin_live_skins_open(const ionskin_live_skin* like, size_t environments,
                                            size_t workers);
void ionskin_live_skins_close(ionskin_live_skins* skins);
/* Environments from `first` to before `last`. Threads may step at once what does not overlap, each
   with a worker of its own, below the number of `open`. Allocates nothing and always returns. */
void ionskin_live_skins_step(ionskin_live_skins* skins, size_t worker, size_t first, size_t last,
                             const ionskin_live_batch* batch);
/* The same with angles [environment][roll, pitch, yaw], of the type of positions, and the stiffness
   [environment][36], doubles, as `ionskin_live_stiffness` tells it; either may be NULL. */
void ionskin_live_skins_step_posed(ionskin_live_skins* skins, size_t worker, size_t first,
                                   size_t last, const ionskin_live_batch* batch, const void* angles,
                                   double* stiffness);
/* The following are those of a single skin, while no thread steps. Friction and noise stay. */
void ionskin_live_skins_reset(ionskin_live_skins* skins, size_t environment);
void ionskin_live_skins_save(const ionskin_live_skins* skins, size_t environment, double* state);
int ionskin_live_skins_restore(ionskin_live_skins* skins, size_t environment, const double* state,
                               size_t size);
int ionskin_live_skins_set_friction(ionskin_live_skins* skins, size_t environment,
                                    double coefficient);
double ionskin_live_skins_friction(const ionskin_live_skins* skins, size_t environment);
/* White noise of so many amperes on every current, which follows from seed and steps alone. */
void ionskin_live_skins_set_noise(ionskin_live_skins* skins, size_t environment, double deviation,
                                  uint64_t seed, uint64_t steps);
uint64_t ionskin_live_skins_noise_steps(ionskin_live_skins* skins, size_t environment);

#ifdef __cplusplus
}
#endif
#endif
