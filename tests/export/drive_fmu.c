/* Steps the FMU's library at argv[1], with the token argv[2], argv[3] steps of argv[4] s; prints the variables from reference
   argv[5] on, argv[6] of them, as bits. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if defined(_WIN32)
#include <windows.h>
#define OPEN(path) (void *)LoadLibraryA(path)
#define SYMBOL(library, name) (void *)GetProcAddress((HMODULE)(library), name)
#else
#include <dlfcn.h>
#define OPEN(path) dlopen(path, RTLD_NOW)
#define SYMBOL(library, name) dlsym(library, name)
#endif

typedef struct {
  void *logger, *allocate, *release, *finished, *environment;
} Callbacks;

int main(int n, char **given) {
  Callbacks callbacks = {0};
  void *library = n == 7 ? OPEN(given[1]) : NULL, *unit;
  void *(*instantiate)(const char *, int, const char *, const char *, Callbacks *, int, int);
  int (*set_up)(void *, int, double, double, int, double), (*enter)(void *), (*leave)(void *);
  int (*step)(void *, double, double, int), (*get)(void *, const unsigned int *, size_t, double *);
  const long steps = n == 7 ? atol(given[3]) : 0, first = n == 7 ? atol(given[5]) : 0, last = n == 7 ? first + atol(given[6]) : 0;
  const double h = n == 7 ? atof(given[4]) : 0;
  long k;
  if (library == NULL) return puts("no library"), 1;
#define TAKE(f, name) (*(void **)&f = SYMBOL(library, name))
  TAKE(instantiate, "fmi2Instantiate"), TAKE(set_up, "fmi2SetupExperiment"), TAKE(enter, "fmi2EnterInitializationMode");
  TAKE(leave, "fmi2ExitInitializationMode"), TAKE(step, "fmi2DoStep"), TAKE(get, "fmi2GetReal");
  unit = instantiate("unit", 1, given[2], "", &callbacks, 0, 0);
  if (unit == NULL || set_up(unit, 0, 0, 0, 0, 0) || enter(unit) || leave(unit)) return puts("no start"), 1;
  for (k = 0; k < steps; ++k) {
    if (step(unit, k * h, h, 1)) return puts("no step"), 1;
  }
  for (k = first; k < last; ++k) {
    const unsigned int reference = (unsigned int)k;
    double value;
    uint64_t bits;
    if (get(unit, &reference, 1, &value)) return puts("no value"), 1;
    memcpy(&bits, &value, sizeof bits);
    printf("%016" PRIx64 " %.17g\n", bits, value);
  }
  return 0;
}
