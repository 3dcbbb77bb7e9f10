/* FMI 3.0: co-simulation and model exchange. */
#include <stdbool.h>

typedef void (*Logger)(void *, int, const char *, const char *);
typedef const unsigned int *References;

static int say(Instance *I, int status, const char *message) {
  Logger call;
  if (I->logger != NULL) {
    memcpy(&call, &I->logger, sizeof call); /* ISO C has no cast from an object's to a function's address */
    call(I->environment, status, status == DISCARD ? "logStatusDiscard" : "logStatusError", message);
  }
  return status;
}

DOOR const char *fmi3GetVersion(void) { return "3.0"; }
DOOR int fmi3SetDebugLogging(Instance *I, bool on, size_t n, const char *const *kinds) { return OK; }

static Instance *logged(const char *name, const char *token, int exchange, void *environment, Logger log) {
  void *logger;
  memcpy(&logger, &log, sizeof logger);
  return made(name, token, exchange, environment, logger);
}
DOOR Instance *fmi3InstantiateModelExchange(const char *name, const char *token, const char *place, bool visible, bool on, void *environment, Logger log) {
  return logged(name, token, 1, environment, log);
}
DOOR Instance *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *place, bool visible, bool on, bool events, bool early,
                                           References wanted, size_t n, void *environment, Logger log, void (*update)(void)) {
  Instance *I = logged(name, token, 0, environment, log);
  if (I != NULL) I->early = early;
  return I;
}
DOOR Instance *fmi3InstantiateScheduledExecution(const char *name, const char *token, const char *place, bool visible, bool on, void *environment, Logger log,
                                                 void (*update)(void), void (*lock)(void), void (*unlock)(void)) {
  return NULL;
}
DOOR void fmi3FreeInstance(Instance *I) { free(I); }
DOOR int fmi3EnterInitializationMode(Instance *I, bool defined, double tolerance, double start, bool ends, double end) {
  return initialise(I, start);
}
DOOR int fmi3ExitInitializationMode(Instance *I) { return leave_initialisation(I); }
DOOR int fmi3EnterEventMode(Instance *I) { return go_to(I, CONTINUOUS, EVENT); }
DOOR int fmi3Terminate(Instance *I) { return I->s.mode = ENDED, OK; }
DOOR int fmi3Reset(Instance *I) { return defaults(I), OK; }

DOOR int fmi3GetFloat64(Instance *I, References vr, size_t n, double *value, size_t m) {
  return n == m ? get(I, vr, n, value) : said(I, ERROR, "as many values as variables", (double)m);
}
DOOR int fmi3SetFloat64(Instance *I, References vr, size_t n, const double *value, size_t m) {
  return n == m ? set(I, vr, n, value) : said(I, ERROR, "as many values as variables", (double)m);
}
#define NONE(Kind, type)                                                                                         \
  DOOR int fmi3Get##Kind(Instance *I, References vr, size_t n, type *value, size_t m) {                          \
    return n == 0 ? OK : say(I, ERROR, "there are only variables of Float64");   \
  }                                                                                                              \
  DOOR int fmi3Set##Kind(Instance *I, References vr, size_t n, const type *value, size_t m) {                    \
    return n == 0 ? OK : say(I, ERROR, "there are only variables of Float64");   \
  }
NONE(Float32, float)
NONE(Int8, int8_t)
NONE(UInt8, uint8_t)
NONE(Int16, int16_t)
NONE(UInt16, uint16_t)
NONE(Int32, int32_t)
NONE(UInt32, uint32_t)
NONE(Int64, int64_t)
NONE(UInt64, uint64_t)
NONE(Boolean, bool)
NONE(String, char *)
#define NO(name, ...) \
  DOOR int fmi3##name(Instance *I, __VA_ARGS__) { return say(I, ERROR, "this unit has no such thing: " #name); }
NO(GetBinary, References vr, size_t n, size_t *size, const uint8_t **value, size_t m)
NO(SetBinary, References vr, size_t n, const size_t *size, const uint8_t *const *value, size_t m)
NO(GetClock, References vr, size_t n, bool *value)
NO(SetClock, References vr, size_t n, const bool *value)
NO(GetNumberOfVariableDependencies, unsigned int vr, size_t *n)
NO(GetVariableDependencies, unsigned int vr, size_t *of, unsigned int *by, size_t *at, int *kind, size_t n)
NO(GetAdjointDerivative, References of, size_t n, References by, size_t m, const double *seed, size_t k, double *found, size_t l)
NO(GetIntervalDecimal, References vr, size_t n, double *value, int *kind)
NO(GetIntervalFraction, References vr, size_t n, uint64_t *count, uint64_t *resolution, int *kind)
NO(GetShiftDecimal, References vr, size_t n, double *value)
NO(GetShiftFraction, References vr, size_t n, uint64_t *count, uint64_t *resolution)
NO(SetIntervalDecimal, References vr, size_t n, const double *value)
NO(SetIntervalFraction, References vr, size_t n, const uint64_t *count, const uint64_t *resolution)
NO(SetShiftDecimal, References vr, size_t n, const double *value)
NO(SetShiftFraction, References vr, size_t n, const uint64_t *count, const uint64_t *resolution)
NO(GetOutputDerivatives, References vr, size_t n, const int32_t *order, double *value, size_t m)
NO(ActivateModelPartition, unsigned int vr, double t)

DOOR int fmi3GetFMUState(Instance *I, void **state) { return keep(I, state); }
DOOR int fmi3SetFMUState(Instance *I, void *state) { return go_back(I, state); }
DOOR int fmi3FreeFMUState(Instance *I, void **state) { return let_go(state); }
DOOR int fmi3SerializedFMUStateSize(Instance *I, void *state, size_t *size) { return *size = sizeof(State), OK; }
DOOR int fmi3SerializeFMUState(Instance *I, void *state, uint8_t *bytes, size_t size) { return as_bytes(I, state, bytes, size); }
DOOR int fmi3DeserializeFMUState(Instance *I, const uint8_t *bytes, size_t size, void **state) { return from_bytes(I, bytes, size, state); }
DOOR int fmi3GetDirectionalDerivative(Instance *I, References of, size_t n, References by, size_t m, const double *seed, size_t k, double *found, size_t l) {
  return m == k && n == l ? derivatives(I, of, n, by, m, seed, found) : say(I, ERROR, "as many values as variables");
}

DOOR int fmi3EnterConfigurationMode(Instance *I) { return OK; }
DOOR int fmi3ExitConfigurationMode(Instance *I) { return OK; }
DOOR int fmi3EvaluateDiscreteStates(Instance *I) { return OK; }
DOOR int fmi3UpdateDiscreteStates(Instance *I, bool *again, bool *terminate, bool *nominals, bool *values, bool *defined, double *next) {
  int ends, moved;
  const int status = answer_events(I, &ends, &moved);
  *again = *nominals = false, *terminate = ends != 0, *values = moved != 0;
  *next = I->s.jump[0], *defined = *next < NEVER;
  return status;
}
DOOR int fmi3EnterContinuousTimeMode(Instance *I) { return go_to(I, EVENT, CONTINUOUS); }
DOOR int fmi3CompletedIntegratorStep(Instance *I, bool no_set, bool *event, bool *terminate) {
  return *event = look_for_events(I) != 0, *terminate = false, OK;
}
DOOR int fmi3SetTime(Instance *I, double t) { return set_time(I, t); }
DOOR int fmi3SetContinuousStates(Instance *I, const double *x, size_t n) { return set_states(I, x, n); }
DOOR int fmi3GetContinuousStateDerivatives(Instance *I, double *x, size_t n) { return get_states(I, x, n, 1); }
DOOR int fmi3GetEventIndicators(Instance *I, double *x, size_t n) { return get_indicators(I, x, n); }
DOOR int fmi3GetContinuousStates(Instance *I, double *x, size_t n) { return get_states(I, x, n, 0); }
DOOR int fmi3GetNominalsOfContinuousStates(Instance *I, double *x, size_t n) { return get_states(I, x, n, 2); }
DOOR int fmi3GetNumberOfEventIndicators(Instance *I, size_t *n) { return *n = NG, OK; }
DOOR int fmi3GetNumberOfContinuousStates(Instance *I, size_t *n) { return *n = NX, OK; }
DOOR int fmi3EnterStepMode(Instance *I) { return I->exchange ? say(I, ERROR, "there are no steps in model exchange") : OK; }
DOOR int fmi3DoStep(Instance *I, double t, double h, bool no_set, bool *event, bool *terminate, bool *early, double *last) {
  const int status = do_step(I, t, h);
  *event = false, *terminate = I->s.ended != 0, *early = *terminate && I->early && I->s.t < t + h, *last = I->s.t;
  return status;
}
