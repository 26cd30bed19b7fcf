/* An exported correction among faults, judged from outside, and its stores among stops of the
 * power.
 *
 *   faults TICKS SEED    random faults; the first broken promise ends it
 *   faults torn SEED     a store is written, and stops after every number of bytes
 *   faults replay        calls and answers of faults.py --script on standard input
 *   faults speed TICKS   time of a call
 *
 *   cc -std=c99 -O2 -I FOLDER_OF_machine.h faults.c -lm -o faults; -DMACHINE_SINGLE for float
 */
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "machine.h"

typedef machine_real real;

static unsigned long random_state;
static long tick;
static unsigned long seed;

/* From 0 up to 1. */
static double uniform(void) {
  unsigned long x = random_state;
  x ^= (x << 13) & 0xffffffffUL;
  x ^= x >> 17;
  x ^= (x << 5) & 0xffffffffUL;
  random_state = x & 0xffffffffUL;
  return (double)random_state / 4294967296.0;
}
static double between(double low, double high) { return low + uniform() * (high - low); }
static int chance(double p) { return uniform() < p; }
static double any_of(const double *values, int count) { return values[(int)(uniform() * count)]; }
#define ANY(values) any_of(values, (int)(sizeof(values) / sizeof *(values)))

static void broken(const char *what, const char *name, double value, double limit) {
  printf("faults: tick %ld, seed %lu: %s%s: %.9g, %.9g\n", tick, seed, what, name, value, limit);
  exit(1);
}

static int finite_number(double x) { return x - x == 0; }

/* What the judge remembers. */
static double believed[machine_inputs + 1], since[machine_inputs + 1],
    read_last[machine_inputs + 1], same[machine_inputs + 1];
static double offset[machine_outputs + 1], above[machine_outputs + 1], slack[machine_outputs + 1];
static double untrusted[machine_outputs + 1], doubt[machine_outputs + 1];
static int started, restarted, waits, has_read[machine_inputs + 1];
static unsigned long counts[32], alarms;

static void begin(void) {
  int k;
  started = restarted = waits = 0;
  for (k = 0; k <= machine_inputs; ++k)
    believed[k] = since[k] = read_last[k] = same[k] = has_read[k] = 0;
  for (k = 0; k <= machine_outputs; ++k)
    offset[k] = above[k] = slack[k] = untrusted[k] = doubt[k] = 0;
}

static void must(unsigned long flags, unsigned long bit, int is_so, const char *what) {
  if (!!(flags & bit) != !!is_so)
    broken(what, is_so ? " is not said" : " is said", (double)flags, (double)bit);
}

static double precision(double size) {
  return (sizeof(real) == sizeof(float) ? 4e-7 : 1e-14) * size;
}

/* One call against the promises; `first`: of the state, whose dt does not count. */
static void judge(const machine_state *s, double dt, int first, const real *in, int enable,
                  const real *out) {
  /* For a clock, since a restart: whether it still is the first call is not promised. */
  const int was_restarted = waits ? (s->flags & machine_restarted) != 0 : restarted;
  const double fine_time = sizeof(real) == sizeof(float) ? 1e-3 : 1e-9;
  double gap = 0, passed = 0;
  int k, i, clock = 0, late = 0, well = 1, must_doubt = 0, may_doubt = 0, hidden = 0;
  int at_fault[machine_inputs + 1];
  restarted = 0;
  waits = was_restarted && !finite_number(dt);
  if (first) {
    gap = 0;
  } else if (!(dt > 0) || !finite_number(dt) ||
             (dt > (double)MACHINE_CLOCK_JUMP && !was_restarted)) {
    clock = 1;
  } else {
    passed = dt;
    gap = dt < (double)MACHINE_LONGEST_GAP ? dt : (double)MACHINE_LONGEST_GAP;
    late = dt > (double)MACHINE_LONGEST_GAP && !was_restarted;
    if (was_restarted) gap = 0;
  }
  must(s->flags, machine_clock, clock, "clock");
  must(s->flags, machine_late, late, "late");
  must(s->flags, machine_restarted, was_restarted, "restarted");
  must(s->flags, machine_was_off, was_restarted && passed > (double)MACHINE_LONGEST_GAP, "was off");
  must(s->flags, machine_disabled, !enable, "disabled");
  if (s->flags & machine_was_off && (int)machine_restart == (int)machine_rest) {
    double kept[machine_outputs + 1], kept_above[machine_outputs + 1],
        kept_slack[machine_outputs + 1];
    for (k = 0; k < machine_outputs; ++k) {
      kept[k] = offset[k];
      kept_above[k] = above[k];
      kept_slack[k] = slack[k];
    }
    begin();
    for (k = 0; k < machine_outputs; ++k) {
      offset[k] = kept[k];
      above[k] = kept_above[k];
      slack[k] = kept_slack[k];
    }
  }
  for (k = 0; k < machine_inputs; ++k) {
    const double v = machine_is_temperature[k] ? (double)in[k] : fabs((double)in[k]);
    const double fastest = (double)machine_fastest[k], stuck = (double)machine_stuck_after[k];
    const int said = k < 32 && (s->faulty_inputs >> k & 1UL);
    int is_bad = 0, may = k >= 32;
    since[k] += was_restarted && clock ? 1e12 : passed; /* nobody knows for how long it was off */
    if (!finite_number(v)) {
      is_bad = 1;
    } else {
      if (has_read[k] && v == read_last[k]) {
        same[k] += gap;
      } else {
        same[k] = 0;
        read_last[k] = v;
        has_read[k] = 1;
      }
      if (v < (double)machine_plausible_low[k] || v > (double)machine_plausible_high[k]) {
        is_bad = 1;
      } else if (same[k] >= stuck * (1 + 10 * fine_time) + gap + fine_time) {
        is_bad = 1;
      } else {
        const double change = fabs(v - believed[k]);
        if (same[k] >= stuck * (1 - 10 * fine_time) - fine_time || fabs(v) > 1e9) may = 1;
        if (started && change > fastest * (since[k] + 3)) {
          is_bad = 1;
#ifdef EXCUSE_JUMPS /* at a bad moment: a clock that stands or is set, a late call, a restart */
          if (was_restarted || clock || late) is_bad = 0, may = 1;
#endif
        } else if (started && change > 0.9 * fastest * (since[k] < gap ? since[k] : gap)) {
          may = 1;
        }
      }
    }
    if (is_bad && !said && !may) broken("input", " at fault, and not named", v, believed[k]);
    if (said && !is_bad && !may) broken("input", " well, and named", v, believed[k]);
    if (said) {
      well = 0;
      if (!(s->flags & machine_alarms))
        broken("input", " named, and no alarm", v, (double)s->flags);
    } else {
      believed[k] = v;
      since[k] = 0;
    }
    at_fault[k] = said;
    if (k >= 32) hidden = 1;
  }
  if (!started && well) started = 1;
  must(s->flags, machine_not_started, !started, "not started");
  if (well && !hidden)
    must(s->flags, machine_no_value | machine_implausible | machine_jumped | machine_stuck, 0,
         "fault");
  if ((clock || late) && !(s->flags & machine_alarms))
    broken("clock", " and no alarm", dt, (double)s->flags);
  for (k = 0; k < machine_outputs; ++k) {
    const double unit = (double)machine_unit[k], now = (double)out[k] * unit, was = offset[k];
    const double limit = (double)machine_limit[k], count = machine_counts[k] ? unit : 0;
    const double fine = precision(limit + fabs(was) + 1), reach = (double)machine_slew[k] * gap;
    const int was_above = above[k] > 0;
    int bad = 0;
    if (!finite_number(now)) broken("offset", "", now, 0);
    if (machine_counts[k] && (double)out[k] != floor((double)out[k]))
      broken("offset", " in counts", (double)out[k], 0);
    if (fabs(now) > limit + fine && fabs(now) > above[k] + fine) broken("limit", "", now, limit);
    if (gap == 0 &&
        fabs(now - was) > slack[k] + (was_above || sizeof(real) == sizeof(float) ? fine : 0))
      broken("moved", " in a call without time", was, now);
    if (fabs(now - was) > reach * (1 + 1e-6) + (was_above ? 2 : 1) * count + fine + slack[k])
      broken("slew", "", fabs(now - was), reach);
    if (above[k] > 0) above[k] = fabs(now) > limit - count ? fabs(now) + count : 0;
    for (i = 0; i < machine_inputs; ++i)
      if (at_fault[i] && machine_uses[k * machine_inputs + i]) bad = 1;
    if (started) {
      if (!finite_number((double)s->absolute[k]))
        broken("displacement", "", (double)s->absolute[k], 0);
      untrusted[k] = bad ? untrusted[k] + gap : 0;
      if (bad && untrusted[k] > (double)MACHINE_HOLD && (int)machine_on_fault != (int)machine_hold)
        doubt[k] =
            doubt[k] + gap / (double)MACHINE_FADE < 1 ? doubt[k] + gap / (double)MACHINE_FADE : 1;
      else if (!bad)
        doubt[k] =
            doubt[k] - gap / (double)MACHINE_FADE > 0 ? doubt[k] - gap / (double)MACHINE_FADE : 0;
      if (untrusted[k] > (double)MACHINE_HOLD * (1 + 1e-4) + fine_time || doubt[k] > 1e-3)
        must_doubt = 1;
      if (untrusted[k] > (double)MACHINE_HOLD * (1 - 1e-4) - fine_time || doubt[k] > 0)
        may_doubt = 1;
    }
    if (!enable && machine_disabled_to_zero && !was_above &&
        fabs(now) > (fabs(was) > reach ? fabs(was) - reach : 0) + 1.5 * count + fine +
                        reach * 1e-6 + slack[k]) {
#ifdef EXCUSE_UNSTARTED
      if (started)
#endif
        broken("disabled", "", was, now);
    }
    if (!enable && !machine_disabled_to_zero && fabs(now - was) > slack[k] + fine && !was_above)
      broken("frozen", "", was, now);
    offset[k] = now;
    slack[k] = 0;
  }
  if (sizeof(real) == sizeof(double)) {
    if (must_doubt && !(s->flags & machine_untrusted))
      broken("untrusted", " is not said", (double)s->flags, 0);
    if (!may_doubt && s->flags & machine_untrusted)
      broken("untrusted", " is said", (double)s->flags, 0);
  }
  for (k = 0; k < 17; ++k) counts[k] += s->flags >> k & 1UL;
  alarms += (s->flags & machine_alarms) != 0;
}

static real as_real(double x) {
  if (sizeof(real) == sizeof(float) && fabs(x) > (double)FLT_MAX)
    return x > 0 ? (real)INFINITY : (real)-INFINITY;
  return (real)x;
}

/* A value within what an input can be and has been. */
static void its_range(int k, double *low, double *high) {
  *low = machine_is_temperature[k] ? 15 : 0;
  *high = machine_is_temperature[k] ? 45 : 3000;
  if ((double)machine_highest[k] < 1e29) *high = (double)machine_highest[k];
  if ((double)machine_lowest[k] > -1e29 && machine_is_temperature[k])
    *low = (double)machine_lowest[k];
  if (*low < (double)machine_plausible_low[k]) *low = (double)machine_plausible_low[k];
  if (*high > (double)machine_plausible_high[k]) *high = (double)machine_plausible_high[k];
}

static int run(long ticks) {
  static machine_state s;
  static double stores[2 * machine_saved];
  static double value[machine_inputs + 1], goal[machine_inputs + 1];
  static int fault[machine_inputs + 1];
  static long left[machine_inputs + 1];
  const double nothing[] = {NAN, INFINITY, -INFINITY}, far[] = {1e308, -1e308, 1e30, 1e12, 850.0};
  const clock_t started_at = clock();
  int k, enable = 1, first = 1;
  double rate = 0, nominal = 1;
  long phase_left = 0;
  machine_init(&s);
  begin();
  for (k = 0; k < machine_inputs; ++k) {
    double low, high;
    its_range(k, &low, &high);
    value[k] = goal[k] = between(low, high);
  }
  for (tick = 0; tick < ticks; ++tick, --phase_left) {
    real in[machine_inputs + 1], out[machine_outputs + 1];
    double dt;
    if (phase_left <= 0) {
      const double rates[] = {0, 0.003, 0.003, 0.15};
      rate = ANY(rates);
      phase_left = (long)between(100, 2500);
      nominal = pow(10, between(-2, log10(0.7 * (double)MACHINE_LONGEST_GAP)));
    }
    dt = nominal * between(0.7, 1.3);
    for (k = 0; k < machine_inputs; ++k) {
      double low, high, most;
      its_range(k, &low, &high);
      if (chance(0.01)) goal[k] = between(low, high);
      most = machine_is_temperature[k] ? 0.05 * (high - low) * dt / 60 : 1e30;
      if ((double)machine_fastest[k] < 1e29 && most > 0.2 * dt * (double)machine_fastest[k])
        most = 0.2 * dt * (double)machine_fastest[k];
      value[k] += goal[k] - value[k] > most    ? most
                  : goal[k] - value[k] < -most ? -most
                                               : goal[k] - value[k];
      in[k] = (real)(value[k] + 1e-3 * uniform());
      if (!fault[k] && chance(rate)) {
        fault[k] = 1 + (int)(uniform() * 5);
        left[k] = chance(0.6) ? 1 : (long)pow(10, between(0, 2.7));
        if (fault[k] == 4) left[k] = (long)(1 + between(0.5, 2) * 300 / nominal);
      }
      if (fault[k] == 1) in[k] = as_real(ANY(nothing));
      if (fault[k] == 2 && (double)machine_plausible_high[k] < 1e8) in[k] = as_real(ANY(far));
      if (fault[k] == 3)
        in[k] = (real)(value[k] +
                       between(-30, 30) *
                           ((double)machine_fastest[k] < 1e29 ? (double)machine_fastest[k] : 1));
      if (fault[k] == 4) in[k] = (real)value[k];
      if (fault[k] == 5) in[k] = -in[k];
      if (fault[k] == 4) value[k] = (double)in[k], goal[k] = value[k];
      if (fault[k] && --left[k] <= 0) fault[k] = 0;
    }
    if (chance(0.1 * rate + 0.0005)) enable = !enable;
    if (chance(rate)) {
      const double kinds[] = {0,
                              -0.0,
                              -dt,
                              -1e9,
                              NAN,
                              INFINITY,
                              -INFINITY,
                              1e308,
                              (double)MACHINE_LONGEST_GAP,
                              (double)MACHINE_CLOCK_JUMP,
                              1.01 * (double)MACHINE_CLOCK_JUMP,
                              between((double)MACHINE_LONGEST_GAP, (double)MACHINE_CLOCK_JUMP),
                              5e-324,
                              1e-9};
      dt = ANY(kinds);
    }
    dt = (double)as_real(dt);
    machine_update(&s, (real)dt, in, enable, out);
    judge(&s, dt, first, in, enable, out);
    first = 0;
    if (chance(0.0005 + 0.02 * rate) && started) {
      k = (int)(uniform() * machine_outputs);
      machine_touch_off(&s, k);
    }
    if (chance(0.001 + 0.03 * rate)) {
      machine_state before = s;
      machine_keep(&s, stores);
      if (chance(0.5)) machine_keep(&s, stores);
      memset(&s, 0x55, sizeof s);
      if (!machine_recall(&s, stores)) broken("recall", "", 0, 0);
      for (k = 0; k < machine_outputs; ++k)
        if (s.sent[k] != before.sent[k] || s.absolute[k] != before.absolute[k])
          broken("recalled", "", 0, 0);
      for (k = 0; k < machine_sums; ++k)
        if (s.sum[k] != before.sum[k] || s.carry[k] != before.carry[k])
          broken("recalled", " sum", 0, 0);
      restarted = 1;
      if (chance(0.2))
        for (k = 0; k < machine_outputs; ++k) {
          double applied = between(-1.2, 1.2) * (double)(machine_limit[k] / machine_unit[k]);
          if (machine_counts[k]) applied = floor(applied);
          if (chance(0.2)) applied = ANY(nothing);
          machine_applied(&s, k, (real)applied);
          if (!finite_number(applied)) continue;
          applied = (double)((real)applied * machine_unit[k]);
          slack[k] = machine_counts[k] ? (double)machine_unit[k] : precision(fabs(applied) + 1);
          if (machine_counts[k] && fabs(applied - offset[k]) <= 1.6 * (double)machine_unit[k])
            slack[k] += fabs(applied - offset[k]);
          above[k] = fabs(applied) > (double)machine_limit[k] ? fabs(applied) : 0;
          offset[k] = applied;
        }
    }
    if (chance(0.00003)) {
      machine_init(&s);
      begin();
      first = 1;
    }
  }
  {
    const double seconds = (double)(clock() - started_at) / (double)CLOCKS_PER_SEC;
    const char *names[] = {
        "beyond range",    "no value",    "beyond table", "beyond element", "clock",  "not started",
        "beyond together", "implausible", "jumped",       "stuck",          "late",   "limited",
        "untrusted",       "moving",      "disabled",     "restarted",      "was off"};
    printf("faults: %ld ticks, seed %lu, %.2f s; alarm %lu", ticks, seed, seconds, alarms);
    for (k = 0; k < 17; ++k) printf(", %s %lu", names[k], counts[k]);
    printf("\n");
  }
  return 0;
}

/* What a store gives, as numbers; 0 where none is whole. */
static int recalled(const double *stores, double *numbers) {
  static machine_state s;
  static double copy[2 * machine_saved];
  memcpy(copy, stores, sizeof copy);
  machine_init(&s);
  if (!machine_recall(&s, copy)) return 0;
  machine_save(&s, numbers);
  return 1;
}

static int torn(void) {
  static machine_state s;
  static double stores[2 * machine_saved], after[2 * machine_saved], half[2 * machine_saved];
  static double old_numbers[machine_saved], new_numbers[machine_saved], got[machine_saved];
  const size_t size = machine_saved * sizeof(double);
  unsigned long stops = 0, was_old = 0, was_new = 0;
  int round, k, has_old = 0;
  size_t n;
  machine_init(&s);
  if (recalled(stores, got)) broken("empty stores", "", 0, 0);
  for (round = 0; round < 2100; ++round) { /* counts begin again at 1000 */
    real in[machine_inputs + 1], out[machine_outputs + 1];
    const int all = round < 6 || (round > 996 && round < 1004) || round > 2096;
    tick = round;
    for (k = 0; k < machine_inputs; ++k) in[k] = (real)between(20, 30);
    machine_update(&s, (real)1, in, 1, out);
    memcpy(after, stores, sizeof after);
    machine_keep(&s, after);
    machine_save(&s, new_numbers);
    for (n = 0; n <= 2 * size; n += all ? 1 : size) {
      int place, same_old, same_new, from_behind;
      for (from_behind = 0; from_behind < 2; ++from_behind) {
        /* The bytes arrive in order, or the last ones first. */
        memcpy(half, stores, sizeof half);
        if (from_behind)
          memcpy((char *)half + (2 * size - n), (char *)after + (2 * size - n), n);
        else
          memcpy(half, after, n);
        ++stops;
        if (!recalled(half, got)) {
          if (has_old) broken("torn", ": no state after so many bytes", (double)n, round);
          continue;
        }
        same_old = has_old && memcmp(got, old_numbers, size) == 0;
        same_new = memcmp(got, new_numbers, size) == 0;
        was_old += same_old != 0;
        was_new += same_new != 0;
        if (!same_old && !same_new)
          broken("torn", ": neither the old nor the new state", (double)n, round);
        if (n == 2 * size && !same_new)
          broken("torn", ": all is written, and the old state is there", (double)n, round);
        /* It goes on from there: what is kept next is what is recalled. */
        if (all) {
          static machine_state next;
          static double next_numbers[machine_saved];
          machine_init(&next);
          machine_recall(&next, half);
          for (place = 0; place < 3; ++place) {
            machine_update(&next, (real)0.5, in, 1, out);
            machine_keep(&next, half);
            machine_save(&next, next_numbers);
            if (!recalled(half, got) || memcmp(got, next_numbers, size) != 0)
              broken("torn", ": what is kept after it is not recalled", (double)n, round);
          }
        }
      }
    }
    memcpy(stores, after, sizeof stores);
    memcpy(old_numbers, new_numbers, sizeof old_numbers);
    has_old = 1;
  }
  /* Any one bit of the newer store: the one before it is taken, or the state is the same. */
  for (n = 0; n < 2 * size * 8; ++n) {
    memcpy(half, stores, sizeof half);
    ((unsigned char *)half)[n / 8] =
        (unsigned char)(((unsigned char *)half)[n / 8] ^ (1U << n % 8));
    if (!recalled(half, got)) broken("flipped", ": no state", (double)n, 0);
  }
  printf("faults: %lu stops in a store of %lu bytes: old state %lu, new one %lu; %lu single bits\n",
         stops, (unsigned long)(2 * size), was_old, was_new, (unsigned long)(2 * size * 8));
  return 0;
}

static double next_number(void) {
  char word[64];
  if (scanf("%63s", word) != 1) return NAN;
  return strtod(word, NULL);
}

static int replay(void) {
  static machine_state s;
  static double stores[2 * machine_saved];
  const double tolerance = sizeof(real) == sizeof(float) ? 2e-2 : 1e-9;
  double last = NAN, largest = 0;
  char word[8];
  int k;
  machine_init(&s);
  while (scanf("%7s", word) == 1) {
    if (word[0] == 'r') {
      machine_keep(&s, stores);
      memset(&s, 0x55, sizeof s);
      if (!machine_recall(&s, stores)) broken("recall", "", 0, 0);
    } else if (word[0] == 'z') {
      machine_init(&s);
      last = NAN;
    } else if (word[0] == 't') {
      machine_touch_off(&s, (int)next_number());
    } else if (word[0] == 'a') {
      for (k = 0; k < machine_outputs; ++k) machine_applied(&s, k, (real)next_number());
    } else {
      real in[machine_inputs + 1], out[machine_outputs + 1];
      const double time = next_number();
      const int enable = next_number() != 0;
      unsigned long status;
      for (k = 0; k < machine_inputs; ++k) in[k] = as_real(next_number());
      machine_update(&s, as_real(time - last), in, enable, out);
      if (finite_number(time)) last = time;
      for (k = 0; k < machine_outputs; ++k) {
        const double expected = next_number(),
                     apart = fabs((double)out[k] - expected) * (double)machine_unit[k];
        if (!(apart <= largest)) largest = apart;
        if (!(apart <= tolerance) && !(machine_counts[k] && sizeof(real) == sizeof(float)))
          broken("offset", " of Python is another", (double)out[k], expected);
      }
      status = (unsigned long)next_number();
      if (s.flags != status && sizeof(real) == sizeof(double))
        broken("status", " of Python is another", (double)s.flags, (double)status);
      ++tick;
    }
  }
  printf("faults: %ld calls of Python and C: the same status, offsets to %.1e um\n", tick, largest);
  return tick == 0;
}

static int speed(long ticks) {
  static machine_state s;
  static double stores[2 * machine_saved];
  real in[machine_inputs + 1], out[machine_outputs + 1], sum = 0;
  double middle[machine_inputs + 1], low, high, call, keep;
  clock_t from;
  long n;
  int k;
  machine_init(&s);
  for (k = 0; k < machine_inputs; ++k) {
    its_range(k, &low, &high);
    middle[k] = low + 0.4 * (high - low);
  }
  from = clock();
  for (n = 0; n < ticks; ++n) {
    for (k = 0; k < machine_inputs; ++k)
      in[k] = (real)(middle[k] + 1e-4 * (double)((n + k) & 1023));
    machine_update(&s, (real)1, in, 1, out);
    sum += out[0];
  }
  call = (double)(clock() - from) / (double)CLOCKS_PER_SEC / (double)ticks;
  from = clock();
  for (n = 0; n < 20000; ++n) machine_keep(&s, stores);
  keep = (double)(clock() - from) / (double)CLOCKS_PER_SEC / 20000;
  printf("faults: %.3f us a call, %.2f us to keep %d numbers (%g)\n", 1e6 * call, 1e6 * keep,
         (int)machine_saved, (double)sum);
  return 0;
}

int main(int argc, char **argv) {
  if (argc == 2 && strcmp(argv[1], "replay") == 0) return replay();
  if (argc == 3 && strcmp(argv[1], "speed") == 0) return speed(strtol(argv[2], NULL, 10));
  if (argc != 3)
    return fprintf(stderr, "faults TICKS SEED | torn SEED | replay | speed TICKS\n"), 2;
  seed = strtoul(argv[2], NULL, 10);
  random_state = (seed * 2654435761UL + 88172645UL) & 0xffffffffUL;
  if (random_state == 0) random_state = 1;
  return strcmp(argv[1], "torn") == 0 ? torn() : run(strtol(argv[1], NULL, 10));
}
