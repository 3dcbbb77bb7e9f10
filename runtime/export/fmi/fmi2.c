/* FMI 2.0: co-simulation and model exchange. */
typedef void (*Logger)(void *, const char *, int, const char *, const char *, ...);
typedef struct {
  Logger logger;
  void *(*allocate)(size_t, size_t);
  void (*release)(void *);
  void (*finished)(void *, int);
  void *environment;
} Callbacks;
typedef struct {
  int again, terminate, nominals, values, defined;
  double next;
} EventInfo;

static int say(Instance *I, int status, const char *message) {
  Logger call;
  if (I->logger != NULL) {
    memcpy(&call, &I->logger, sizeof call); /* ISO C has no cast from an object's to a function's address */
    call(I->environment, I->name, status, status == DISCARD ? "logStatusDiscard" : "logStatusError", "%s", message);
  }
  return status;
}

DOOR const char *fmi2GetTypesPlatform(void) { return "default"; }
DOOR const char *fmi2GetVersion(void) { return "2.0"; }
DOOR int fmi2SetDebugLogging(Instance *I, int on, size_t n, const char *const *kinds) { return OK; }

DOOR Instance *fmi2Instantiate(const char *name, int type, const char *token, const char *place, const Callbacks *f, int visible, int on) {
  void *logger = NULL;
  if (f != NULL) memcpy(&logger, &f->logger, sizeof logger);
  return made(name, token, type == 0, f == NULL ? NULL : f->environment, logger);
}
DOOR void fmi2FreeInstance(Instance *I) { free(I); }
DOOR int fmi2SetupExperiment(Instance *I, int defined, double tolerance, double start, int ends, double end) {
  if (I->s.mode != INSTANTIATED) return say(I, ERROR, "the experiment is set up before the initialisation");
  if (!(start - start == 0.0)) return said(I, ERROR, "the start time must be finite", start);
  I->s.started = I->s.t = start;
  return OK;
}
DOOR int fmi2EnterInitializationMode(Instance *I) { return initialise(I, I->s.started); }
DOOR int fmi2ExitInitializationMode(Instance *I) { return leave_initialisation(I); }
DOOR int fmi2Terminate(Instance *I) { return I->s.mode = ENDED, OK; }
DOOR int fmi2Reset(Instance *I) { return defaults(I), OK; }

DOOR int fmi2GetReal(Instance *I, const unsigned int *vr, size_t n, double *value) { return get(I, vr, n, value); }
DOOR int fmi2SetReal(Instance *I, const unsigned int *vr, size_t n, const double *value) { return set(I, vr, n, value); }
#define NONE(Kind, type)                                                                                    \
  DOOR int fmi2Get##Kind(Instance *I, const unsigned int *vr, size_t n, type *value) {                      \
    return n == 0 ? OK : say(I, ERROR, "there are only real variables");             \
  }                                                                                                         \
  DOOR int fmi2Set##Kind(Instance *I, const unsigned int *vr, size_t n, const type *value) {                \
    return n == 0 ? OK : say(I, ERROR, "there are only real variables");             \
  }
NONE(Integer, int)
NONE(Boolean, int)
NONE(String, char *)

DOOR int fmi2GetFMUstate(Instance *I, void **state) { return keep(I, state); }
DOOR int fmi2SetFMUstate(Instance *I, void *state) { return go_back(I, state); }
DOOR int fmi2FreeFMUstate(Instance *I, void **state) { return let_go(state); }
DOOR int fmi2SerializedFMUstateSize(Instance *I, void *state, size_t *size) { return *size = sizeof(State), OK; }
DOOR int fmi2SerializeFMUstate(Instance *I, void *state, char *bytes, size_t size) { return as_bytes(I, state, bytes, size); }
DOOR int fmi2DeSerializeFMUstate(Instance *I, const char *bytes, size_t size, void **state) { return from_bytes(I, bytes, size, state); }
DOOR int fmi2GetDirectionalDerivative(Instance *I, const unsigned int *unknown, size_t n, const unsigned int *known, size_t m, const double *seed, double *found) {
  return derivatives(I, unknown, n, known, m, seed, found);
}

DOOR int fmi2EnterEventMode(Instance *I) { return go_to(I, CONTINUOUS, EVENT); }
DOOR int fmi2NewDiscreteStates(Instance *I, EventInfo *info) {
  memset(info, 0, sizeof *info);
  const int status = answer_events(I, &info->terminate, &info->values);
  info->next = I->s.jump[0], info->defined = info->next < NEVER;
  return status;
}
DOOR int fmi2EnterContinuousTimeMode(Instance *I) { return go_to(I, EVENT, CONTINUOUS); }
DOOR int fmi2CompletedIntegratorStep(Instance *I, int no_set, int *event, int *terminate) {
  return *event = look_for_events(I), *terminate = 0, OK;
}
DOOR int fmi2SetTime(Instance *I, double t) { return set_time(I, t); }
DOOR int fmi2SetContinuousStates(Instance *I, const double *x, size_t n) { return set_states(I, x, n); }
DOOR int fmi2GetDerivatives(Instance *I, double *x, size_t n) { return get_states(I, x, n, 1); }
DOOR int fmi2GetEventIndicators(Instance *I, double *x, size_t n) { return get_indicators(I, x, n); }
DOOR int fmi2GetContinuousStates(Instance *I, double *x, size_t n) { return get_states(I, x, n, 0); }
DOOR int fmi2GetNominalsOfContinuousStates(Instance *I, double *x, size_t n) { return get_states(I, x, n, 2); }

DOOR int fmi2SetRealInputDerivatives(Instance *I, const unsigned int *vr, size_t n, const int *order, const double *value) {
  size_t k;
  for (k = 0; k < n; ++k) {
    if (vr[k] < VR_P + NPAR || vr[k] >= VR_Y || order[k] != 1 || !(value[k] - value[k] == 0.0)) {
      return said(I, ERROR, "first derivatives of inputs only, and finite ones", (double)vr[k]);
    }
    I->s.slope[vr[k] - VR_P - NPAR] = value[k];
  }
  return OK;
}
DOOR int fmi2GetRealOutputDerivatives(Instance *I, const unsigned int *vr, size_t n, const int *order, double *value) {
  return say(I, ERROR, "derivatives of outputs are outputs themselves");
}
DOOR int fmi2DoStep(Instance *I, double t, double h, int no_set) {
  const int status = do_step(I, t, h);
  return status == OK && I->s.ended ? said(I, DISCARD, "an event has ended the motion", I->s.t) : status;
}
DOOR int fmi2CancelStep(Instance *I) { return say(I, ERROR, "a step is not asynchronous"); }
#define STATUS(Kind, type)                                                                 \
  DOOR int fmi2Get##Kind(Instance *I, int kind, type *value) {                             \
    return say(I, DISCARD, "a step is not asynchronous");         \
  }
STATUS(Status, int)
STATUS(IntegerStatus, int)
DOOR int fmi2GetBooleanStatus(Instance *I, int kind, int *value) { return *value = kind == 3 && I->s.ended, OK; }
STATUS(StringStatus, const char *)
DOOR int fmi2GetRealStatus(Instance *I, int kind, double *value) { return *value = I->s.t, OK; }
