/* SPDX-License-Identifier: Apache-2.0 */
#ifndef IONSKIN_LIVE_FMU_FMI2_H
#define IONSKIN_LIVE_FMU_FMI2_H

/* The functions of the Functional Mock-up Interface 2.0 for co-simulation, and their types, declared after the text of
   the standard (fmi-standard.org, version 2.0, sections 2.1 and 4.2). */

#include <stddef.h>

#define IONSKIN_FMI2_EXPORT __attribute__((visibility("default")))

#ifdef __cplusplus
extern "C" {
#endif

typedef void* fmi2Component;
typedef void* fmi2ComponentEnvironment;
typedef void* fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char* fmi2String;
typedef char fmi2Byte;

enum { fmi2False = 0, fmi2True = 1 };
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum {
  fmi2DoStepStatus,
  fmi2PendingStatus,
  fmi2LastSuccessfulTime,
  fmi2Terminated
} fmi2StatusKind;

/* `logger` takes a format as printf does. */
typedef struct {
  void (*logger)(fmi2ComponentEnvironment, fmi2String instance, fmi2Status, fmi2String category,
                 fmi2String message, ...);
  void* (*allocateMemory)(size_t, size_t);
  void (*freeMemory)(void*);
  void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

IONSKIN_FMI2_EXPORT const char* fmi2GetTypesPlatform(void);
IONSKIN_FMI2_EXPORT const char* fmi2GetVersion(void);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component, fmi2Boolean on, size_t count,
                                                   const fmi2String categories[]);

IONSKIN_FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type, fmi2String guid,
                                                  fmi2String resources,
                                                  const fmi2CallbackFunctions*, fmi2Boolean visible,
                                                  fmi2Boolean logging);
IONSKIN_FMI2_EXPORT void fmi2FreeInstance(fmi2Component);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean has_tolerance,
                                                   fmi2Real tolerance, fmi2Real start,
                                                   fmi2Boolean has_stop, fmi2Real stop);
IONSKIN_FMI2_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component);
IONSKIN_FMI2_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component);
IONSKIN_FMI2_EXPORT fmi2Status fmi2Terminate(fmi2Component);
IONSKIN_FMI2_EXPORT fmi2Status fmi2Reset(fmi2Component);

IONSKIN_FMI2_EXPORT fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference[], size_t count,
                                           fmi2Real[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetInteger(fmi2Component, const fmi2ValueReference[],
                                              size_t count, fmi2Integer[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetBoolean(fmi2Component, const fmi2ValueReference[],
                                              size_t count, fmi2Boolean[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetString(fmi2Component, const fmi2ValueReference[],
                                             size_t count, fmi2String[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference[], size_t count,
                                           const fmi2Real[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetInteger(fmi2Component, const fmi2ValueReference[],
                                              size_t count, const fmi2Integer[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetBoolean(fmi2Component, const fmi2ValueReference[],
                                              size_t count, const fmi2Boolean[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetString(fmi2Component, const fmi2ValueReference[],
                                             size_t count, const fmi2String[]);

IONSKIN_FMI2_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component, fmi2FMUstate*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component, fmi2FMUstate);
IONSKIN_FMI2_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate,
                                                          size_t* size);
IONSKIN_FMI2_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate, fmi2Byte[],
                                                     size_t size);
IONSKIN_FMI2_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte[],
                                                       size_t size, fmi2FMUstate*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component,
                                                            const fmi2ValueReference unknowns[],
                                                            size_t unknown_count,
                                                            const fmi2ValueReference knowns[],
                                                            size_t known_count,
                                                            const fmi2Real known_changes[],
                                                            fmi2Real unknown_changes[]);

IONSKIN_FMI2_EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component,
                                                           const fmi2ValueReference[],
                                                           size_t count, const fmi2Integer order[],
                                                           const fmi2Real[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component,
                                                            const fmi2ValueReference[],
                                                            size_t count,
                                                            const fmi2Integer order[], fmi2Real[]);
IONSKIN_FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component, fmi2Real communication_point,
                                          fmi2Real step_size, fmi2Boolean no_way_back);
IONSKIN_FMI2_EXPORT fmi2Status fmi2CancelStep(fmi2Component);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component, fmi2StatusKind, fmi2Real*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind, fmi2Boolean*);
IONSKIN_FMI2_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*);

#ifdef __cplusplus
}
#endif
#endif
