/* SPDX-License-Identifier: Apache-2.0 */
#ifndef IONSKIN_LIVE_H
#define IONSKIN_LIVE_H

/* C interface of the reduced-order skin: a model trained by `ionskin live`, which is stepped in
   real time and returns forces, charges and currents. SI units. Within one interface number,
   functions are only added. A skin may be used by one thread at a time; skins of one file share its
   data. `step`, `run`, `save`, `restore` and `reset` allocate nothing and always return. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define IONSKIN_LIVE_INTERFACE 1

/* Bits of the flags that a step returns; 0 for a valid step within the trained range. */
#define IONSKIN_LIVE_OUTSIDE_PLACE 1u /* the nearest trained position was used */
#define IONSKIN_LIVE_OUTSIDE_LOAD                                                                  \
  2u /* load above the trained one: the largest trained one was used */
#define IONSKIN_LIVE_OUTSIDE_SPEED 4u /* slide or spin faster than trained */
#define IONSKIN_LIVE_UNCONVERGED 8u   /* contact residual above 1e-3 */
#define IONSKIN_LIVE_REFUSED 16u      /* refused: NaN, infinity, an earlier time; nothing changed */
#define IONSKIN_LIVE_PULLED 32u       /* negative force: the slider detaches */
/* tilt steeper than trained: the steepest trained one in that direction was used; or yaw of a slider
   that was trained without turns and does not look alike from all sides: no yaw was used */
#define IONSKIN_LIVE_OUTSIDE_POSE 64u

/* Kind of load of a step: held height or held normal force. */
enum { IONSKIN_LIVE_HEIGHT = 0, IONSKIN_LIVE_FORCE = 1 };

/* A reduced-order skin with its state. Made by `ionskin_live_open` and `ionskin_live_copy`, freed
   by `ionskin_live_close`. */
typedef struct ionskin_live_skin ionskin_live_skin;

/* Interface number of the library, to be compared with IONSKIN_LIVE_INTERFACE. */
uint32_t ionskin_live_interface(void);

/* Opens a `.live` file and returns a skin at rest without contact. If the file cannot be used,
   returns NULL and writes the reason to `message`, cut to `size` bytes with the terminating 0;
   nothing is written if `size` is 0. */
ionskin_live_skin* ionskin_live_open(const char* path, char* message, size_t size);
/* Returns another skin of the same file, in the same state and with the same friction; NULL when
   out of memory. */
ionskin_live_skin* ionskin_live_copy(const ionskin_live_skin* skin);
/* Frees a skin; NULL is allowed. */
void ionskin_live_close(ionskin_live_skin* skin);

/* Number of signals that a step writes. */
size_t ionskin_live_signal_count(const ionskin_live_skin* skin);
/* Name of a signal, as in signals.csv and taxels.csv; NULL if `signal` is beyond the last. The text
   lives as long as the skin. */
const char* ionskin_live_signal_name(const ionskin_live_skin* skin, size_t signal);

/* Advances the skin to a time [s], not before that of the last step, with an upright slider whose
   centre is at x, y [m]. `value` is, if `kind` is IONSKIN_LIVE_HEIGHT, the height of the underside
   above the undeformed top face [m], negative when it indents; if `kind` is IONSKIN_LIVE_FORCE, the
   normal force on the whole skin [N], 0 for no contact. `signals` receives signal_count values.
   Returns the flags. */
uint32_t ionskin_live_step(ionskin_live_skin* skin, double time, double x, double y, int kind,
                           double value, double* signals);
/* Advances the skin as `ionskin_live_step` does, with a slider that is tilted and turned: roll,
   pitch and yaw [rad], as slider.roll, slider.pitch and slider.yaw of a case. A height is that of
   the lowest point of the underside. */
uint32_t ionskin_live_step_posed(ionskin_live_skin* skin, double time, double x, double y,
                                 const double angles[3], int kind, double value, double* signals);
/* Advances the skin with a slider that is held by a normal force [N] and by moments about x and y
   [N m]: roll and pitch follow from them, and `ionskin_live_angles` tells them. The moments are
   those of the forces on the skin, about the slider's centre on the undeformed top face. Where a
   steeper tilt than trained would be needed, IONSKIN_LIVE_OUTSIDE_POSE is set. */
uint32_t ionskin_live_step_held(ionskin_live_skin* skin, double time, double x, double y,
                                double yaw, double force, const double moments[2], double* signals);
/* Writes roll, pitch and yaw that the last step took [rad]. */
void ionskin_live_angles(const ionskin_live_skin* skin, double angles[3]);
/* Makes `count` steps, one after the other, as `ionskin_live_step` does: times [count], positions
   [count][x, y], values [count]; results signals [count][signal_count], flags [count]. */
void ionskin_live_run(ionskin_live_skin* skin, size_t count, const double* times,
                      const double* positions, int kind, const double* values, double* signals,
                      uint32_t* flags);

/* Computes the derivative of the wrench on the skin, at the end of the last step, by a rigid motion
   of the slider, while the beginning of the step stays as it was. `stiffness` receives 6 rows,
   forces along x, y, z [N] and moments about x, y, z [N m], of 6 columns, translations along x, y,
   z [m] and rotations about x, y, z through the slider's centre on the undeformed top face [rad].
   Allocates nothing. Returns 1; or 0, with NaN in all entries, before the first step, after
   `restore` and `reset`, or if the equations were not solved. Of a skin that is modelled as one
   symmetric half, the columns of translation along y and rotation about x and z are unknown, and
   NaN. */
int ionskin_live_stiffness(ionskin_live_skin* skin, double stiffness[36]);

/* Number of charges among the signals: top electrode, bottom electrode, and each taxel. */
size_t ionskin_live_charge_count(const ionskin_live_skin* skin);
/* Computes the derivatives of the charges, at the end of the last step, by the rigid motions of
   `ionskin_live_stiffness`: [charge_count][6] [C/m], [C/rad], for the signals whose names begin
   with charge_, in their order. Allocates nothing. Returns 1; or 0, with NaN, where
   `ionskin_live_stiffness` does. Its NaN columns are NaN here too. */
int ionskin_live_charge_derivatives(ionskin_live_skin* skin, double* derivatives);

/* Makes `count` steps as `ionskin_live_run` does, with a tilted and turned slider: angles
   [count][roll, pitch, yaw] [rad]. */
void ionskin_live_run_posed(ionskin_live_skin* skin, size_t count, const double* times,
                            const double* positions, const double* angles, int kind,
                            const double* values, double* signals, uint32_t* flags);

/* Number of values of a state. */
size_t ionskin_live_state_size(const ionskin_live_skin* skin);
/* Copies the state of a skin to `state` [state_size], for `ionskin_live_restore`. */
void ionskin_live_save(const ionskin_live_skin* skin, double* state);
/* Replaces the state by one that `ionskin_live_save` wrote for a skin of the same file, in `size`
   values. Returns 1; or 0, with nothing changed, if no step can leave such a state: its size
   differs, or a number is not finite or out of range. */
int ionskin_live_restore(ionskin_live_skin* skin, const double* state, size_t size);
/* Resets the state to that of a skin at rest without contact. */
void ionskin_live_reset(ionskin_live_skin* skin);

/* Sets the coefficient of friction, which is not part of the state. Allocates memory. Returns 1; or
   0, with nothing changed, if it is outside the trained range or memory is lacking. */
int ionskin_live_set_friction(ionskin_live_skin* skin, double coefficient);
/* Writes the present coefficient of friction, and the lowest and highest trained one. */
void ionskin_live_friction(const ionskin_live_skin* skin, double friction[3]);

/* Text of the file. `what` is "case" (case file), "version" or "command" of the training, or
   "shortfall": one line on the events whose reported errors exceed the promised one, empty if there
   is none. NULL for any other word. The text lives as long as the skin. */
const char* ionskin_live_text(const ionskin_live_skin* skin, const char* what);
/* Writes the trained range: lowest x, y, highest x, y of the slider's centre [m], largest force
   [N], largest indentation [m], highest speed [m/s]. */
void ionskin_live_range(const ionskin_live_skin* skin, double range[7]);
/* Writes the trained range of poses: largest tilt [rad] and fastest rotation about z [rad/s], 0 for
   none; then 1 if the underside is rotationally symmetric about z, else 0. */
void ionskin_live_pose_range(const ionskin_live_skin* skin, double range[3]);
/* Writes the length and width of the skin [m]. */
void ionskin_live_size(const ionskin_live_skin* skin, double size[2]);
/* Writes the lowest x, y, highest x, y of the contact cells, from the slider's centre [m]. The
   slider touches nothing beyond them. */
void ionskin_live_footprint(const ionskin_live_skin* skin, double box[4]);
/* Thickness of the core [m]. */
double ionskin_live_core_thickness(const ionskin_live_skin* skin);
/* Writes the name of a taxel, and its lowest x, y, highest x, y [m]. Returns 1; or 0 if `index` is
   beyond the last. The name lives as long as the skin. */
int ionskin_live_taxel(const ionskin_live_skin* skin, size_t index, const char** name,
                       double corners[4]);
/* Writes the reported error of a signal on touches that were not used for training: rms and largest
   error, and largest value of the signal, in its unit. Returns 1; or 0 if `index` is beyond the
   last error of whole touches. */
int ionskin_live_error(const ionskin_live_skin* skin, size_t index, const char** name, double* rms,
                       double* worst, double* largest);

/* Writes a reported error as `ionskin_live_error` does, with the event of the touches in which it
   is taken: "landing", "slip_onset", "hold", "lift" or "load_step". Errors over whole touches come
   first, with an empty event. Returns 1; or 0 if `index` is beyond the last. */
int ionskin_live_event_error(const ionskin_live_skin* skin, size_t index, const char** event,
                             const char** name, double* rms, double* worst, double* largest);

/* Most rows of a random touch. */
#define IONSKIN_LIVE_TOUCH_ROWS 16

/* Draws a random touch such as the skin was validated on, within the trained range: the slider
   waits above the skin, lands, slides and rests in turn, turns back, changes its load, lifts off
   and waits. Writes waypoints of 7 values, at most IONSKIN_LIVE_TOUCH_ROWS: time from 0 [s], x and
   y of the slider's centre [m], the load, and roll, pitch and yaw [rad]. All of them change
   linearly from row to row. `kind` receives how the skin was validated: IONSKIN_LIVE_FORCE, and the
   load is a normal force on the whole skin [N], 0 without contact; or IONSKIN_LIVE_HEIGHT, and the
   load is the height of the underside [m]. Returns the number of rows; 0 when out of memory. One
   seed gives the same touch on every machine. */
size_t ionskin_live_random_touch(const ionskin_live_skin* skin, uint64_t seed, double* waypoints,
                                 int* kind);

/* Many skins of one file, stepped together, as environments of a learner. The result of an
   environment depends neither on the other environments nor on the worker that steps it. */
typedef struct ionskin_live_skins ionskin_live_skins;

/* Inputs and outputs of a step of all environments, in memory of the caller. */
typedef struct ionskin_live_batch {
  const double* times;     /* [environment] [s] */
  const void* positions;   /* [environment][x, y] [m] */
  const void* values;      /* height [m] or force [N] [environment] */
  void* signals;           /* result [environment][column] */
  uint32_t* flags;         /* result: bits of IONSKIN_LIVE_... [environment] */
  const uint32_t* columns; /* indices of the signals that are written [column_count] */
  size_t column_count;
  int kind;   /* IONSKIN_LIVE_HEIGHT or IONSKIN_LIVE_FORCE */
  int single; /* not 0: positions, values and signals are floats; 0: doubles */
} ionskin_live_batch;

/* Makes skins that are all in the state and with the friction of `like`, without noise; NULL when
   out of memory, and if `environments` or `workers` is 0. `workers` is the number of threads that
   may step at once. */
ionskin_live_skins* ionskin_live_skins_open(const ionskin_live_skin* like, size_t environments,
                                            size_t workers);
/* Frees the skins; NULL is allowed. */
void ionskin_live_skins_close(ionskin_live_skins* skins);
/* Advances the environments from `first` to before `last`. Several threads may do so at the same
   time for ranges that do not overlap, each with a `worker` of its own, below the number given to
   `ionskin_live_skins_open`. Allocates nothing and always returns. */
void ionskin_live_skins_step(ionskin_live_skins* skins, size_t worker, size_t first, size_t last,
                             const ionskin_live_batch* batch);
/* Advances the environments as `ionskin_live_skins_step` does, with angles [environment][roll,
   pitch, yaw] [rad], of the type of the positions, or NULL for upright sliders. `stiffness`
   receives the matrices of `ionskin_live_stiffness` [environment][36] as doubles, or is NULL. */
void ionskin_live_skins_step_posed(ionskin_live_skins* skins, size_t worker, size_t first,
                                   size_t last, const ionskin_live_batch* batch, const void* angles,
                                   double* stiffness);
/* Resets one environment, as `ionskin_live_reset` does; friction and noise stay. This function and
   the following ones may not be called while a thread steps. */
void ionskin_live_skins_reset(ionskin_live_skins* skins, size_t environment);
/* Copies the state of one environment, as `ionskin_live_save` does. */
void ionskin_live_skins_save(const ionskin_live_skins* skins, size_t environment, double* state);
/* Replaces the state of one environment, as `ionskin_live_restore` does. */
int ionskin_live_skins_restore(ionskin_live_skins* skins, size_t environment, const double* state,
                               size_t size);
/* Sets the friction of one environment, as `ionskin_live_set_friction` does. */
int ionskin_live_skins_set_friction(ionskin_live_skins* skins, size_t environment,
                                    double coefficient);
/* Coefficient of friction of one environment. */
double ionskin_live_skins_friction(const ionskin_live_skins* skins, size_t environment);
/* Sets the standard deviation [A] of the white noise on every current of an environment. The noise
   depends only on `seed` and on the number of steps taken with it, which begins at `steps`. */
void ionskin_live_skins_set_noise(ionskin_live_skins* skins, size_t environment, double deviation,
                                  uint64_t seed, uint64_t steps);
/* Number of steps that an environment has taken with its noise. */
uint64_t ionskin_live_skins_noise_steps(ionskin_live_skins* skins, size_t environment);

#ifdef __cplusplus
}
#endif
#endif
