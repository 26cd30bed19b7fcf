/* Runs an exported correction by a script on standard input. Lines: see control_test.cpp. */
#include <stdio.h>
#include <string.h>

#include "machine.h"

int main(void) {
  static machine_state machine;
  char word[16];
  double last = 0;
  machine_init(&machine);
  while (scanf("%15s", word) == 1) {
    if (strcmp(word, "restart") == 0) {
      double saved[machine_saved];
      machine_save(&machine, saved);
      memset(&machine, 0x55, sizeof machine);
      if (!machine_restore(&machine, saved)) return 1;
      saved[1] += 1;
      if (machine_restore(&machine, saved)) return 2; /* damaged */
    } else if (strcmp(word, "reset") == 0) {
      machine_init(&machine);
    } else if (strcmp(word, "zero") == 0) {
      machine_set_zero(&machine);
    } else {
      machine_real in[machine_inputs], out[machine_outputs];
      double time, value;
      int k;
      if (scanf("%lf", &time) != 1) return 3;
      for (k = 0; k < machine_inputs; ++k) {
        if (scanf("%lf", &value) != 1) return 3;
        in[k] = (machine_real)value;
      }
      machine_update(&machine, (machine_real)(time - last), in, out);
      last = time;
      for (k = 0; k < machine_outputs; ++k) printf("%.17g ", (double)out[k]);
      printf("%u\n", machine.flags);
    }
  }
  return 0;
}
