#include <fmt/format.h>

#include <cmath>

#include "io/control_files.h"
#include "io/control_text.h"

namespace raceway::io {
namespace {

constexpr std::string_view head =
    R"(component @NAME@ "Thermal correction: displacements from temperatures, speeds and feeds";
description """
@HEADING@
    halcompile --install @NAME@.comp      (not as a realtime component: it needs none)
    loadusr -Wn @NAME@ @NAME@ state-file  (the file keeps what it remembers over a restart)

Connect all inputs, then set enable: what they are at the first call is where temperatures count
from. Displacements are in um, as modelled; an axis moves against them. External offsets take
counts of their own scale.
""";
@PINS@pin in bit enable "while false nothing moves; what passes meanwhile is a gap";
pin in bit reset "true: begins anew from rest, with the temperatures of then";
pin in bit zero "while true displacements count from where they are, as after a touch-off";
pin in float interval = 1.0 "between two calls [s], 0.01 to 60";
pin out unsigned status_bits "bits: 1 input beyond its range, 2 no number, 4 beyond the friction table, 8 power beyond a delay element, 16 clock, 32 not started, 64 inputs together as never seen";
pin out unsigned beyond_bits "bits: which of the inputs, in the order of these pins, is beyond its range";
option userspace yes;
option singleton yes;
option userinit yes;
license "MIT";
;;

#include <signal.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

)";

constexpr std::string_view loop = R"c(
static @NAME@_state machine;
static const char *state_file;
static double last_call; /* [s] since 1970: a machine that was off is a gap */

static double seconds_since_1970(void) {
  struct timespec t;
  clock_gettime(CLOCK_REALTIME, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void read_state(void) {
  double saved[@NAME@_saved], at;
  int k;
  FILE *file = state_file ? fopen(state_file, "r") : NULL;
  if (!file) return;
  k = fscanf(file, "%lf", &at) == 1 ? 0 : -1;
  while (k >= 0 && k < @NAME@_saved && fscanf(file, "%lf", &saved[k]) == 1) ++k;
  fclose(file);
  if (k == @NAME@_saved && @NAME@_restore(&machine, saved))
    last_call = at;
  else
    fprintf(stderr, "@NAME@: %s is not of this model, or damaged: begins from rest\n", state_file);
}

/* A whole file or none, also where the power fails. */
static void write_state(void) {
  char beside[4096];
  double saved[@NAME@_saved];
  int k, good;
  FILE *file;
  if (!state_file || snprintf(beside, sizeof beside, "%s.new", state_file) >= (int)sizeof beside)
    return;
  file = fopen(beside, "w");
  if (!file) return;
  @NAME@_save(&machine, saved);
  good = fprintf(file, "%.17g\n", last_call) > 0;
  for (k = 0; k < @NAME@_saved; ++k) good = fprintf(file, "%.17g\n", saved[k]) > 0 && good;
  good = fflush(file) == 0 && fsync(fileno(file)) == 0 && good;
  if (fclose(file) == 0 && good) rename(beside, state_file);
}

void userinit(int argc, char **argv) {
  if (argc > 1) state_file = argv[1];
  @NAME@_init(&machine);
  read_state();
}

static volatile sig_atomic_t told_to_stop;
static void stop(int number) {
  (void)number;
  told_to_stop = 1;
}

void user_mainloop(void) {
  double saved_at = 0;
  signal(SIGTERM, stop);
  signal(SIGINT, stop);
  while (!told_to_stop) {
    double wait = 1;
    FOR_ALL_INSTS() {
      const double at = seconds_since_1970();
      wait = interval >= 0.01 && interval <= 60 ? interval : 1;
      if (reset) @NAME@_init(&machine);
      if (enable) {
        @NAME@_real in[@NAME@_inputs + 1], out[@NAME@_outputs];
@READ@        @NAME@_update(&machine, @NAME@_R(at - last_call), in, out);
        last_call = at;
        if (zero) {
          int k;
          @NAME@_set_zero(&machine);
          for (k = 0; k < @NAME@_outputs; ++k) out[k] = 0;
        }
@WRITE@        if (!(at - saved_at < 10 && at >= saved_at)) {
          write_state();
          saved_at = at;
        }
      }
      status_bits = machine.flags;
      beyond_bits = (unsigned)(machine.beyond_inputs & 0xffffffffUL);
    }
    usleep((useconds_t)(wait * 1e6));
  }
  if (machine.started) write_state();
}
)c";

}  // namespace

std::string control_linuxcnc(const ControlPlan& plan, std::string_view name) {
  const std::string component(name);
  std::string pins, read, write;
  for (const ControlInput& in : plan.inputs) {
    // What switches is a bit in HAL.
    pins += fmt::format("pin in {} {} \"{}{}\";\n", in.column == "coolant_on" ? "bit" : "float",
                        in.identifier, in.unit,
                        std::isnan(in.lowest)
                            ? std::string()
                            : fmt::format(", found in {:.6g} to {:.6g}", in.lowest, in.highest));
    read += fmt::format("        in[{0}_in_{1}] = {1};\n", name, in.identifier);
  }
  for (const ControlAxis& a : plan.axes) {
    pins += fmt::format("pin out float {} \"um\";\n", a.identifier);
    write += fmt::format("        {1} = out[{0}_out_{1}];\n", name, a.identifier);
  }
  return filled(head,
                {{"NAME", component}, {"HEADING", control_heading(plan, "")}, {"PINS", pins}}) +
         control_c(plan, name) +
         filled(loop, {{"NAME", component}, {"READ", read}, {"WRITE", write}});
}

}  // namespace raceway::io
