/* Runs an exported correction by a script on standard input. Lines: see control_test.cpp. */
#include <stdio.h>
#include <string.h>

#include "machine.h"

static double next_number(void) {
  double value;
  if (scanf("%lf", &value) != 1) value = NAN;
  return value;
}

int main(void) {
  static machine_state machine;
  static double stores[2 * machine_saved];
  char word[16];
  double last = 0;
  int k;
  machine_init(&machine);
  while (scanf("%15s", word) == 1) {
    if (strcmp(word, "restart") == 0) {
      machine_keep(&machine, stores);
      memset(&machine, 0x55, sizeof machine);
      if (!machine_recall(&machine, stores)) return 1;
    } else if (strcmp(word, "reset") == 0) {
      machine_init(&machine);
    } else if (strcmp(word, "touch-off") == 0) {
      for (k = 0; k < machine_outputs; ++k) machine_touch_off(&machine, k);
    } else if (strcmp(word, "applied") == 0) {
      for (k = 0; k < machine_outputs; ++k)
        machine_applied(&machine, k, (machine_real)next_number());
    } else {
      machine_real in[machine_inputs + 1], out[machine_outputs];
      const double time = next_number();
      const int guarded = strcmp(word, "g") == 0, enable = guarded && next_number() != 0;
      for (k = 0; k < machine_inputs; ++k) in[k] = (machine_real)next_number();
      if (guarded)
        machine_update(&machine, (machine_real)(time - last), in, enable, out);
      else
        machine_predict(&machine, (machine_real)(time - last), in, out);
      last = time;
      for (k = 0; k < machine_outputs; ++k) printf("%.17g ", (double)out[k]);
      printf("%lu\n", machine.flags);
    }
  }
  return 0;
}
