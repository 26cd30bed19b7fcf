#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/control_files.h"
#include "io/control_text.h"

namespace raceway::io {
namespace {

constexpr std::string_view program = R"c(@HEADING@/*
 * As a part of a control:
 *
 *   static @P@_state machine;          // all that it remembers
 *   @P@_init(&machine);
 *   in[@P@_in_...] = ...; // of all inputs
 *   @P@_update(&machine, seconds_since_the_last_call, in, out);
 *   if (machine.flags) ...             // what is not as it should be: @P@_flag
 *
 * @P@_save() and @P@_restore() keep the state over a restart; the first dt after it is the
 * time since the last call before it. C99, math.h alone, no allocation; not for -ffast-math. With
 * @U@_SINGLE defined all is float: sums carry what a float would round away.
 */
#ifndef @U@_INCLUDED
#define @U@_INCLUDED

#include <math.h>

#ifdef @U@_SINGLE
typedef float @P@_real;
#define @P@_expm1 expm1f
#define @P@_exp expf
#define @P@_log logf
#define @P@_pow powf
#else
typedef double @P@_real;
#define @P@_expm1 expm1
#define @P@_exp exp
#define @P@_log log
#define @P@_pow pow
#endif
#define @P@_R(x) ((@P@_real)(x))
#define @U@_POWER @POWER@ /* of a friction table drives a part */

/* Inputs, in their units, and displacements [um]. */
enum {
@INPUT_NAMES@  @P@_inputs = @INPUTS@
};
enum {
@OUTPUT_NAMES@  @P@_outputs = @OUTPUTS@
};

typedef enum {
  @P@_beyond_range = 1,   /* an input: instant parts are held at its limit; beyond_inputs has its bit */
  @P@_no_value = 2,       /* an input is no number: its last good value holds */
  @P@_beyond_table = 4,   /* a friction table: its edge holds */
  @P@_beyond_element = 8, /* a power that a delay element cannot take: it stands still */
  @P@_clock = 16,         /* dt is not above 0: nothing moves */
  @P@_not_started = 32,   /* no call yet in which all inputs had a value: displacements are 0 */
  @P@_beyond_together = 64 /* the inputs stand together as the model has never seen them */
} @P@_flag;

enum {
  @P@_sections_count = @SECTIONS_COUNT@,
  @P@_elements_count = @ELEMENTS_COUNT@,
  @P@_sums = @P@_sections_count + @P@_elements_count,
  @P@_drives_count = @DRIVES_COUNT@,
  @P@_feedthroughs_count = @FEEDTHROUGHS_COUNT@,
  @P@_kinematics_count = @KINEMATICS_COUNT@,
  @P@_together_count = @TOGETHER_COUNT@,
  @P@_speed = @SPEED@,    /* of the inputs; -1: none */
  @P@_coolant = @COOLANT@,
  /* Numbers of a saved state. */
  @P@_saved = 3 + 2 * @P@_inputs + 2 * @P@_sums + @P@_outputs
};
static const double @P@_stamp = @STAMP@; /* of the numbers below: a state of others is refused */

typedef struct {
  int started;
  unsigned flags;                  /* of the last call, @P@_flag */
  unsigned long beyond_inputs;     /* one bit for each of the first 32 */
  @P@_real first[@P@_inputs + 1];   /* at the first call, from which temperatures count */
  @P@_real last[@P@_inputs + 1];    /* at the last call */
  @P@_real sum[@P@_sums + 1];       /* sections, then delay elements [um] */
  @P@_real carry[@P@_sums + 1];     /* what rounding took from them */
  @P@_real datum[@P@_outputs + 1];  /* see @P@_set_zero() */
  @P@_real absolute[@P@_outputs + 1];
} @P@_state;

/* Lowest and highest value that the numbers were found in; 1e30: not known. */
static const @P@_real @P@_lowest[] = {@LOWEST@};
static const @P@_real @P@_highest[] = {@HIGHEST@};
static const int @P@_is_temperature[] = {@TEMPERATURES@};

/* What the models have seen of inputs at once: |weights (x - mean)| was at most `farthest`. */
static const int @P@_together_inputs[] = {@TOGETHER_INPUTS@};
static const @P@_real @P@_together_mean[] = {@TOGETHER_MEAN@};
static const @P@_real @P@_together_weights[] = {@TOGETHER_WEIGHTS@}; /* lower triangles, row by row */
typedef struct {
  int from, count, weights;
  @P@_real farthest;
} @P@_together;
static const @P@_together @P@_clouds[] = {
@TOGETHER@};

#if @U@_POWER
/* Points of tables. */
static const @P@_real @P@_points[] = {
@POINTS@};
#endif

enum { @P@_rise, @P@_size, @P@_power, @P@_motor };
enum { @P@_line, @P@_power_law, @P@_table };
static const int @P@_drive_inputs[] = {@DRIVE_INPUTS@};
typedef struct {
  int kind, from_input, count, reference;
  int temperature;                    /* of a power: the input, or -1 for the next number [C] */
  @P@_real at_temperature, decay_rpm;  /* of a motor */
  @P@_real low, high;                  /* of a power [W] */
  int speeds, temperatures, torques, speed_count, temperature_count; /* places in the points */
  @P@_real exponent;                   /* of a size, which is x (x/1000)^(exponent - 1) */
} @P@_drive;
static const @P@_drive @P@_drives[] = {
@DRIVES@};

/* Gains in um per unit of the drive, time constants in s. */
typedef struct {
  int output, drive, straight;
  @P@_real gain, time_constant, direct, off_gain, off_time_constant, speed_factor, gain_power, falling;
} @P@_section;
static const @P@_section @P@_sections[] = {
@SECTIONS@};

typedef struct {
  int kind, powers, values, count;
  @P@_real factor, other;
} @P@_curve;
typedef struct {
  int output, drive;
  @P@_real scale, power_limit;
  @P@_curve gain, time_constant;
} @P@_element;
static const @P@_element @P@_elements[] = {
@ELEMENTS@};

typedef struct {
  int output, drive;
  @P@_real gain;
} @P@_feedthrough;
static const @P@_feedthrough @P@_feedthroughs[] = {
@FEEDTHROUGHS@};

typedef struct {
  int output;
  @P@_real A, B, C; /* um, 1, 1/rpm */
} @P@_kinematic;
static const @P@_kinematic @P@_kinematics[] = {
@KINEMATICS@};

static const @P@_real @P@_offset[] = {@OFFSETS@};

static inline int @P@_is_number(@P@_real x) { return x - x == 0; }

static inline @P@_real @P@_within(@P@_real x, @P@_real low, @P@_real high) {
  return x < low ? low : x > high ? high : x;
}

#if @U@_POWER
/* Straight between points of a rising axis; the ends hold. Gives the share of the way to the next. */
static inline @P@_real @P@_place(const @P@_real *axis, int count, @P@_real x, int *at, int *inside) {
  *at = 0;
  if (count < 2) return 0;
  if (x <= axis[0] || x >= axis[count - 1]) {
    const int above = x >= axis[count - 1];
    if (x < axis[0] || x > axis[count - 1]) *inside = 0;
    *at = above ? count - 2 : 0;
    return above ? @P@_R(1) : @P@_R(0);
  }
  while (axis[*at + 1] <= x) ++*at;
  return (x - axis[*at]) / (axis[*at + 1] - axis[*at]);
}

static inline @P@_real @P@_between(const @P@_real *values, int at, @P@_real share) {
  return share == 0 ? values[at] : values[at] + share * (values[at + 1] - values[at]);
}

static inline @P@_real @P@_torque(const @P@_drive *d, @P@_real speed, @P@_real temperature, int *inside) {
  int i, j;
  const @P@_real along = @P@_place(@P@_points + d->speeds, d->speed_count, speed, &i, inside);
  const @P@_real up =
      @P@_place(@P@_points + d->temperatures, d->temperature_count, temperature, &j, inside);
  const @P@_real *row = @P@_points + d->torques + j * d->speed_count;
  const @P@_real cold = @P@_between(row, i, along);
  return up == 0 ? cold : cold + up * (@P@_between(row + d->speed_count, i, along) - cold);
}

static inline @P@_real @P@_curve_at(const @P@_curve *c, @P@_real power) {
  int at, inside = 1;
  @P@_real share;
  if (c->kind == @P@_line) return c->factor * power + c->other;
  if (c->kind == @P@_power_law) return c->factor * @P@_pow(power, c->other);
  share = @P@_place(@P@_points + c->powers, c->count, power, &at, &inside);
  return @P@_between(@P@_points + c->values, at, share);
}
#endif

static inline @P@_real @P@_drive_at(const @P@_state *s, const @P@_drive *d, const @P@_real *in,
                                   unsigned *flags) {
  @P@_real u = 0;
  int k;
  if (d->kind == @P@_rise || d->kind == @P@_size) {
    for (k = d->from_input; k < d->from_input + d->count; ++k) {
      const int i = @P@_drive_inputs[k];
      const @P@_real x = in[i] < @P@_highest[i] ? in[i] : @P@_highest[i];
      if (d->kind == @P@_rise)
        u += in[i] - s->first[i];
      else if (d->exponent == @P@_R(1))
        u += in[i];
      else if (x > 0)
        u += x * @P@_pow(x / @P@_R(1000), d->exponent - @P@_R(1));
    }
    u /= @P@_R(d->count);
    return d->reference < 0 ? u : u - (in[d->reference] - s->first[d->reference]);
  }
  u = in[@P@_speed < 0 ? 0 : @P@_speed];
  if (d->kind == @P@_motor) {
    k = @P@_speed < 0 ? 0 : @P@_speed;
    return u > 0 ? @P@_exp(-@P@_within(u, @P@_lowest[k], @P@_highest[k]) / d->decay_rpm) : @P@_R(0);
  }
#if @U@_POWER
  k = 1;
  u *= @P@_torque(d, u, d->temperature < 0 ? d->at_temperature : in[d->temperature], &k) *
       @P@_R(1e-3 * 3.14159265358979323846 / 30);
  if (!k) *flags |= @P@_beyond_table;
#else
  (void)flags;
#endif
  return u;
}

static inline int @P@_is_together(const @P@_real *in) {
  int c, k, j, w;
  for (c = 0; c < @P@_together_count; ++c) {
    const @P@_together *t = &@P@_clouds[c];
    @P@_real square = 0;
    for (k = 0, w = t->weights; k < t->count; ++k) {
      @P@_real z = 0;
      for (j = t->from; j <= t->from + k; ++j, ++w)
        z += @P@_together_weights[w] * (in[@P@_together_inputs[j]] - @P@_together_mean[j]);
      square += z * z;
    }
    if (square > t->farthest * t->farthest * @P@_R(1.0002)) return 0;
  }
  return 1;
}

/* What drives, as it is and as it is for instant parts: within the range of what was seen. Rest is
   known: what acts by its size is held at its highest alone. */
static inline void @P@_drive_all(const @P@_state *s, const @P@_real *in, @P@_real *within, @P@_real *u,
                                @P@_real *held, unsigned *flags, unsigned long *out_of_range) {
  int k;
  for (k = 0; k < @P@_inputs; ++k) {
    within[k] = @P@_within(in[k], @P@_is_temperature[k] ? @P@_lowest[k] : @P@_R(-1e30), @P@_highest[k]);
    if (in[k] >= @P@_lowest[k] && in[k] <= @P@_highest[k]) continue;
    *flags |= @P@_beyond_range;
    if (k < 32) *out_of_range |= 1UL << k;
  }
  if (!@P@_is_together(in)) *flags |= @P@_beyond_together;
  for (k = 0; k < @P@_drives_count; ++k) {
    const @P@_drive *d = &@P@_drives[k];
    u[k] = @P@_drive_at(s, d, in, flags);
    held[k] = @P@_drive_at(s, d, within, flags);
    if (d->kind != @P@_power) continue;
    if (u[k] < d->low || u[k] > d->high) *flags |= @P@_beyond_range;
    held[k] = @P@_within(held[k], @P@_R(-1e30), d->high);
  }
}

/* 1 - (1 - exp(-x))/x: what a straight course adds to the step of a lag. */
static inline @P@_real @P@_weight(@P@_real x) {
  if (x < @P@_R(1e-2))
    return x * (@P@_R(1.0 / 2) -
                x * (@P@_R(1.0 / 6) -
                     x * (@P@_R(1.0 / 24) -
                          x * (@P@_R(1.0 / 120) - x * (@P@_R(1.0 / 720) - x * @P@_R(1.0 / 5040))))));
  return 1 + @P@_expm1(-x) / x;
}

static inline void @P@_add(@P@_state *s, int k, @P@_real change) {
  const @P@_real y = change - s->carry[k], sum = s->sum[k] + y;
  s->carry[k] = (sum - s->sum[k]) - y;
  s->sum[k] = sum;
}

static inline @P@_real @P@_section_step(const @P@_section *p, @P@_real sum, @P@_real dt, @P@_real before,
                                       @P@_real after, @P@_real speed, int off) {
  const @P@_real f = 1 / (1 + p->speed_factor * speed / 10000);
  const @P@_real gain = p->speed_factor == 0 ? p->gain : p->gain * @P@_pow(f, p->gain_power);
  const @P@_real was = (off ? gain * p->off_gain : gain) * before;
  const @P@_real is = p->straight ? (off ? gain * p->off_gain : gain) * after : was;
  @P@_real ratio = dt / (p->time_constant * f * (off ? p->off_time_constant : 1));
  if ((@P@_R(0.5) * (was + is) - sum) * p->gain < 0) ratio /= p->falling;
  return -@P@_expm1(-ratio) * (was - sum) + (p->straight ? @P@_weight(ratio) * (is - was) : 0);
}

static inline void @P@_step(@P@_state *s, @P@_real dt, const @P@_real *after) {
  @P@_real within[@P@_inputs + 1], before[@P@_drives_count + 1], held[@P@_drives_count + 1];
  unsigned flags = 0;
  unsigned long out_of_range = 0;
  int k, off;
  @P@_real speed;
  within[0] = 0;
  @P@_drive_all(s, s->last, within, before, held, &flags, &out_of_range);
  speed = @P@_speed < 0 ? 0 : within[@P@_speed < 0 ? 0 : @P@_speed];
  off = @P@_coolant >= 0 && s->last[@P@_coolant < 0 ? 0 : @P@_coolant] < @P@_R(0.5);
  for (k = 0; k < @P@_sections_count; ++k) {
    const @P@_section *p = &@P@_sections[k];
    @P@_add(s, k, @P@_section_step(p, s->sum[k], dt, before[p->drive], after[p->drive], speed, off));
  }
#if @U@_POWER
  for (k = 0; k < @P@_elements_count; ++k) {
    const @P@_element *e = &@P@_elements[k];
    const int sum = @P@_sections_count + k;
    const @P@_real P = held[e->drive];
    if (!(P >= 0 && P < e->power_limit)) continue;
    @P@_add(s, sum, -@P@_expm1(-dt / @P@_curve_at(&e->time_constant, P)) *
                       ((P > 0 ? e->scale * @P@_curve_at(&e->gain, P) : 0) - s->sum[sum]));
  }
#endif
}

static inline void @P@_sum_up(@P@_state *s, const @P@_real *held, const @P@_real *within) {
  int k;
  for (k = 0; k < @P@_outputs; ++k) s->absolute[k] = @P@_offset[k];
  for (k = 0; k < @P@_sections_count; ++k) {
    const @P@_section *p = &@P@_sections[k];
    s->absolute[p->output] += s->sum[k];
    if (p->direct != 0)
      s->absolute[p->output] += p->direct * (p->gain * held[p->drive] - s->sum[k]);
  }
  for (k = 0; k < @P@_elements_count; ++k) {
    const @P@_element *e = &@P@_elements[k];
    s->absolute[e->output] += s->sum[@P@_sections_count + k];
    if (!(held[e->drive] >= 0 && held[e->drive] < e->power_limit)) s->flags |= @P@_beyond_element;
  }
  for (k = 0; k < @P@_feedthroughs_count; ++k)
    s->absolute[@P@_feedthroughs[k].output] +=
        @P@_feedthroughs[k].gain * held[@P@_feedthroughs[k].drive];
  for (k = 0; k < @P@_kinematics_count; ++k) {
    const @P@_kinematic *law = &@P@_kinematics[k];
    const @P@_real n = within[@P@_speed < 0 ? 0 : @P@_speed];
    if (n > 0)
      s->absolute[law->output] += law->A * @P@_exp((1 - law->B * @P@_exp(-law->C * n)) * @P@_log(n));
  }
}

/* From rest, as cold as at the next call. */
static inline void @P@_init(@P@_state *s) {
  int k;
  s->started = 0;
  s->flags = @P@_not_started;
  s->beyond_inputs = 0;
  for (k = 0; k < @P@_inputs; ++k) s->first[k] = s->last[k] = 0;
  for (k = 0; k < @P@_sums; ++k) s->sum[k] = s->carry[k] = 0;
  for (k = 0; k < @P@_outputs; ++k) s->datum[k] = s->absolute[k] = 0;
}

/* One call: dt [s] since the last one as measured (of the first call it does not count), inputs and
   displacements by the names above. */
static inline void @P@_update(@P@_state *s, @P@_real dt, const @P@_real *input, @P@_real *output) {
  @P@_real in[@P@_inputs + 1], within[@P@_inputs + 1];
  @P@_real u[@P@_drives_count + 1], held[@P@_drives_count + 1];
  int k;
  s->flags = 0;
  s->beyond_inputs = 0;
  within[0] = 0;
  for (k = 0; k < @P@_inputs; ++k) {
    in[k] = @P@_is_temperature[k] || input[k] >= 0 ? input[k] : -input[k];
    if (@P@_is_number(in[k])) continue;
    s->flags |= @P@_no_value;
    if (!s->started) s->flags |= @P@_not_started;
    in[k] = s->last[k];
  }
  for (k = 0; k < @P@_outputs; ++k) output[k] = 0;
  if (s->flags & @P@_not_started) return;
  if (!s->started)
    for (k = 0; k < @P@_inputs; ++k) s->first[k] = s->last[k] = in[k];
  @P@_drive_all(s, in, within, u, held, &s->flags, &s->beyond_inputs);
  if (s->started) {
    if (dt > 0 && @P@_is_number(dt))
      @P@_step(s, dt, u);
    else
      s->flags |= @P@_clock;
  }
  s->started = 1;
  for (k = 0; k < @P@_inputs; ++k) s->last[k] = in[k];
  @P@_sum_up(s, held, within);
  for (k = 0; k < @P@_outputs; ++k) output[k] = s->absolute[k] - s->datum[k];
}

/* Counts displacements from where they are now, as after a touch-off. */
static inline void @P@_set_zero(@P@_state *s) {
  int k;
  for (k = 0; k < @P@_outputs; ++k) s->datum[k] = s->absolute[k];
}

/* All that is remembered as @P@_saved numbers, the last of them a check sum. */
static inline void @P@_save(const @P@_state *s, double *saved) {
  int k, n = 0;
  double check = 0;
  saved[n++] = @P@_stamp;
  saved[n++] = s->started;
  for (k = 0; k < @P@_inputs; ++k) saved[n++] = s->first[k];
  for (k = 0; k < @P@_inputs; ++k) saved[n++] = s->last[k];
  for (k = 0; k < @P@_sums; ++k) saved[n++] = s->sum[k];
  for (k = 0; k < @P@_sums; ++k) saved[n++] = s->carry[k];
  for (k = 0; k < @P@_outputs; ++k) saved[n++] = s->datum[k];
  for (k = 0; k < n; ++k) check += (k + 1) * saved[k];
  saved[n] = check;
}

/* 1, or 0 where the numbers are damaged or of another model: the state is then left as it is. */
static inline int @P@_restore(@P@_state *s, const double *saved) {
  int k, n = 2;
  double check = 0;
  for (k = 0; k < @P@_saved - 1; ++k) check += (k + 1) * saved[k];
  if (saved[0] != @P@_stamp || check != saved[@P@_saved - 1]) return 0;
  @P@_init(s);
  s->started = saved[1] != 0;
  for (k = 0; k < @P@_inputs; ++k) s->first[k] = @P@_R(saved[n++]);
  for (k = 0; k < @P@_inputs; ++k) s->last[k] = @P@_R(saved[n++]);
  for (k = 0; k < @P@_sums; ++k) s->sum[k] = @P@_R(saved[n++]);
  for (k = 0; k < @P@_sums; ++k) s->carry[k] = @P@_R(saved[n++]);
  for (k = 0; k < @P@_outputs; ++k) s->datum[k] = @P@_R(saved[n++]);
  return 1;
}

#endif
)c";

/// The numbers of a plan as C writes them.
class Numbers {
 public:
  Numbers(const ControlPlan& plan, std::string_view name) : plan_(plan), name_(name) {
    for (const ControlTogether& t : plan.together) add(t);
    for (const ControlDrive& d : plan.drives) add(d);
    for (std::size_t k = 0; k < plan.axes.size(); ++k) add(plan.axes[k], k);
  }

  [[nodiscard]] std::vector<Replacement> replacements() const {
    std::string input_names, output_names, lowest, highest, temperatures, offsets;
    for (std::size_t k = 0; k < plan_.inputs.size(); ++k) {
      const ControlInput& in = plan_.inputs[k];
      input_names += fmt::format("  {}_in_{} = {}, /* {}{} */\n", name_, in.identifier, k, in.unit,
                                 std::isnan(in.lowest)
                                     ? std::string()
                                     : fmt::format(", {:.15g} to {:.15g}", in.lowest, in.highest));
      lowest += real(std::isnan(in.lowest) ? -unbounded : in.lowest) + ", ";
      highest += real(std::isnan(in.highest) ? unbounded : in.highest) + ", ";
      temperatures += in.temperature ? "1, " : "0, ";
    }
    for (std::size_t k = 0; k < plan_.axes.size(); ++k) {
      output_names += fmt::format("  {}_out_{} = {}, /* {} */\n", name_, plan_.axes[k].identifier,
                                  k, harmless(plan_.axes[k].name));
      offsets += real(plan_.axes[k].offset_um) + ", ";
    }
    std::string capitals = name_;
    for (char& c : capitals)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return {{"P", name_},
            {"U", capitals},
            {"HEADING", "/*\n" + control_heading(plan_, " * ") + " */\n"},
            {"POWER", plan_.tables.empty() ? "0" : "1"},
            {"STAMP", fmt::format("{}.0", stamp(plan_))},
            {"INPUT_NAMES", input_names},
            {"OUTPUT_NAMES", output_names},
            {"INPUTS", std::to_string(plan_.inputs.size())},
            {"OUTPUTS", std::to_string(plan_.axes.size())},
            {"SPEED", place(plan_.speed)},
            {"COOLANT", place(plan_.coolant)},
            {"LOWEST", listed_or_zero(lowest)},
            {"HIGHEST", listed_or_zero(highest)},
            {"TEMPERATURES", listed_or_zero(temperatures)},
            {"OFFSETS", listed_or_zero(offsets)},
            {"POINTS", points_.empty() ? "  0\n" : points_},
            {"DRIVE_INPUTS", listed_or_zero(drive_inputs_)},
            {"DRIVES_COUNT", std::to_string(plan_.drives.size())},
            {"DRIVES", rows(drives_, "{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}")},
            {"TOGETHER_COUNT", std::to_string(plan_.together.size())},
            {"TOGETHER_INPUTS", listed_or_zero(together_inputs_)},
            {"TOGETHER_MEAN", listed_or_zero(together_mean_)},
            {"TOGETHER_WEIGHTS", listed_or_zero(together_weights_)},
            {"TOGETHER", rows(together_, "{0, 0, 0, 0}")},
            {"SECTIONS_COUNT", std::to_string(section_count_)},
            {"SECTIONS", rows(sections_, "{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}")},
            {"ELEMENTS_COUNT", std::to_string(element_count_)},
            {"ELEMENTS", rows(elements_, "{0, 0, 0, 0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}}")},
            {"FEEDTHROUGHS_COUNT", std::to_string(feedthrough_count_)},
            {"FEEDTHROUGHS", rows(feedthroughs_, "{0, 0, 0}")},
            {"KINEMATICS_COUNT", std::to_string(kinematic_count_)},
            {"KINEMATICS", rows(kinematics_, "{0, 0, 0, 0}")}};
  }

 private:
  static constexpr double unbounded = 1e30;  // of a float too

  [[nodiscard]] std::string real(double value) const {
    return fmt::format("{}_R({})", name_, control_number(value, "1e30"));
  }
  static std::string place(std::size_t index) {
    return index == nowhere ? "-1" : std::to_string(index);
  }
  // C has no empty arrays.
  static std::string listed_or_zero(const std::string& list) { return list.empty() ? "0" : list; }
  static std::string rows(const std::string& text, std::string_view instead) {
    return text.empty() ? fmt::format("  {}\n", instead) : text;
  }

  std::size_t add_points(const std::vector<double>& values, std::string_view what) {
    points_ += fmt::format("  /* {} */ ", what);
    for (const double v : values) points_ += real(v) + ", ";
    points_ += "\n";
    const std::size_t first = point_count_;
    point_count_ += values.size();
    return first;
  }

  void add(const ControlTogether& t) {
    together_ += fmt::format("  {{{}, {}, {}, {}}},\n", together_input_count_, t.inputs.size(),
                             together_weight_count_, real(t.farthest));
    for (const std::size_t k : t.inputs) together_inputs_ += fmt::format("{}, ", k);
    for (const double v : t.mean) together_mean_ += real(v) + ", ";
    for (const double v : t.weights) together_weights_ += real(v) + ", ";
    together_input_count_ += t.inputs.size();
    together_weight_count_ += t.weights.size();
  }

  void add(const ControlDrive& d) {
    constexpr std::string_view kinds[] = {"rise", "size", "power", "motor"};
    std::size_t speeds = 0, temperatures = 0, torques = 0, speed_count = 0, temperature_count = 0;
    if (d.table != nowhere) {
      const ControlTable& t = plan_.tables[d.table];
      const std::string file = harmless(t.file);
      speeds = add_points(t.speed_rpm, fmt::format("{} at {:g} N: rpm", file, t.axial_load_N));
      temperatures = add_points(t.temperature_C, "C");
      torques = add_points(t.torque_Nmm, "N mm, speed first");
      speed_count = t.speed_rpm.size();
      temperature_count = t.temperature_C.size();
    }
    drives_ += fmt::format("  {{{}_{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}},\n",
                           name_, kinds[static_cast<std::size_t>(d.kind)], drive_input_count_,
                           d.inputs.size(), place(d.reference), place(d.temperature),
                           real(std::isnan(d.temperature_C) ? 0.0 : d.temperature_C),
                           real(std::isnan(d.decay_rpm) ? 1.0 : d.decay_rpm),
                           real(std::isnan(d.lowest) ? -unbounded : d.lowest),
                           real(std::isnan(d.highest) ? unbounded : d.highest), speeds,
                           temperatures, torques, speed_count, temperature_count, real(d.exponent));
    for (const std::size_t k : d.inputs) drive_inputs_ += fmt::format("{}, ", k);
    drive_input_count_ += d.inputs.size();
  }

  std::string curve(const ControlCurve& c, std::string_view what) {
    if (c.kind == ControlCurve::Kind::table) {
      const std::size_t powers = add_points(c.power_W, "W");
      const std::size_t values = add_points(c.value, what);
      return fmt::format("{{{}_table, {}, {}, {}, 0, 0}}", name_, powers, values, c.value.size());
    }
    return fmt::format("{{{}_{}, 0, 0, 0, {}, {}}}", name_,
                       c.kind == ControlCurve::Kind::line ? "line" : "power_law", real(c.factor),
                       real(c.other));
  }

  void add(const ControlAxis& a, std::size_t output) {
    for (const ControlSection& s : a.sections)
      sections_ += fmt::format("  {{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}, /* {} */\n",
                               output, s.drive, s.straight ? 1 : 0, real(s.gain),
                               real(s.time_constant_s), real(s.direct), real(s.off_gain),
                               real(s.off_time_constant), real(s.speed_factor), real(s.gain_power),
                               real(s.falling), harmless(s.channel));
    for (const ControlElement& e : a.elements)
      elements_ += fmt::format("  {{{}, {}, {}, {},\n   {},\n   {}}}, /* {} */\n", output, e.drive,
                               real(e.scale), real(e.power_limit_W), curve(e.gain_um, "um"),
                               curve(e.time_constant_s, "s"), harmless(e.channel));
    for (const ControlFeedthrough& f : a.feedthroughs)
      feedthroughs_ += fmt::format("  {{{}, {}, {}}}, /* {} */\n", output, f.drive, real(f.gain),
                                   harmless(f.channel));
    for (const ControlKinematic& k : a.kinematics)
      kinematics_ += fmt::format("  {{{}, {}, {}, {}}},\n", output, real(k.A_um), real(k.B),
                                 real(k.C_per_rpm));
    section_count_ += a.sections.size();
    element_count_ += a.elements.size();
    feedthrough_count_ += a.feedthroughs.size();
    kinematic_count_ += a.kinematics.size();
  }

  const ControlPlan& plan_;
  std::string name_;
  std::string together_, together_inputs_, together_mean_, together_weights_;
  std::size_t together_input_count_ = 0, together_weight_count_ = 0;
  std::string points_, drive_inputs_, drives_, sections_, elements_, feedthroughs_, kinematics_;
  std::size_t point_count_ = 0, drive_input_count_ = 0, section_count_ = 0, element_count_ = 0,
              feedthrough_count_ = 0, kinematic_count_ = 0;
};

}  // namespace

std::string control_c(const ControlPlan& plan, std::string_view name) {
  return filled(program, Numbers(plan, name).replacements());
}

}  // namespace raceway::io
