"""Model files that have all that an export may have."""
import os
import shutil

PARTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "models")


def part(name):
    with open(os.path.join(PARTS, name)) as source:
        return source.read()


RANGE = part("range.toml")
BOTH = part("axis_z.toml") + part("axis_y.toml")
BOTH_IN_RANGE = part("axis_z.toml") + RANGE + part("axis_y.toml") + RANGE
GUARDED = """plausible = { front_temperature_C = [-10, 120], rear-left_temperature_C = [-40, 150], base_temperature_C = [0, 80], \
room_temperature_C = [-5, 60], speed_rpm = [0, 20000], x_feed_m_min = [0, 60], y_feed_m_min = [0, 60], \
table_speed_rpm = [0, 1000], coolant_on = [0, 1] }
"""
SMALL = """[correction]
displacement = "displacement_z_um"
[[correction.channel]]
name = "spindle"
input = "front_temperature_C"
feedthrough_um_K = 1.5
sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]
"""


def six_channels():
    text = '[correction]\ndisplacement = "displacement_z_um"\n'
    for k, name in enumerate(["front", "rear", "motor", "head", "base", "room"]):
        text += (
            '[[correction.channel]]\nname = "%s"\ninput = "%s_temperature_C"\n'
            "sections = [{ gain_um_K = %g, time_constant_s = %d }, { gain_um_K = %g, time_constant_s = %d }]\n"
            % (name, name, 1.5 - 0.4 * k, 5400 + 100 * k, 0.7 + 0.1 * k, 700 + 10 * k)
        )
    text += "[correction.range]\n"
    for name in ["front", "rear", "motor", "head", "base", "room"]:
        text += "%s_temperature_C = [15, 50]\n" % name
    return text


MODELS = {
    # All that there is, on two axes; a table in each way that [export] knows.
    "full": BOTH_IN_RANGE
    + """[export]
limit_um = { displacement_z_um = 60, displacement_y_um = 45.05 }
slew_um_s = { displacement_z_um = 0.5, displacement_y_um = 0.2 }
sign = { displacement_y_um = 1 }
unit = { displacement_z_um = "mm", displacement_y_um = "counts" }
count_um = { displacement_y_um = 0.1 }
fastest_per_s = { front_temperature_C = 0.5, speed_rpm = 2000, room_temperature_C = 0.1 }
stuck_s = { front_temperature_C = 300, rear-left_temperature_C = 500, base_temperature_C = 3600 }
smoothing_s = { front_temperature_C = 30, speed_rpm = 5 }
hold_s = 20
fade_s = 60
clock_jump_s = 600
"""
    + GUARDED,
    "zero": BOTH_IN_RANGE
    + """[export]
limit_um = 30
slew_um_s = 0.3
unit = { displacement_z_um = "um", displacement_y_um = "counts" }
count_um = { displacement_y_um = 0.7 }
stuck_s = 200
on_fault = "zero"
hold_s = 0
fade_s = 30
restart = "resume"
touch_off = "clear"
disabled = "freeze"
beyond_range = "hold"
longest_gap_s = 5
clock_jump_s = 5
"""
    + GUARDED,
    "hold": BOTH_IN_RANGE
    + """[export]
limit_um = { displacement_z_um = 12.3, displacement_y_um = 0.7 }
slew_um_s = 2
unit = "counts"
count_um = { displacement_z_um = 0.3, displacement_y_um = 0.1 }
fastest_per_s = 0.2
stuck_s = 100
smoothing_s = 12
on_fault = "hold"
hold_s = 15
restart = "rest"
longest_gap_s = 3
clock_jump_s = 100
"""
    + GUARDED,
    # Nothing is known of inputs, nothing is asked of them; together.
    "bare": BOTH
    + """[export]
plausible = { front_temperature_C = [-40, 150] }
fastest_per_s = 0
stuck_s = 0
hold_s = 5
fade_s = 20
""",
    "together": """[correction]
displacement = "displacement_z_um"
[[correction.channel]]
name = "spindle"
input = "front_temperature_C"
sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]
[[correction.channel]]
name = "speed"
input = "speed_rpm"
exponent = 2.5
sections = [{ gain_um_rpm = 0.002, time_constant_s = 900 }]
[correction.together]
columns = ["front_temperature_C", "speed_rpm"]
mean = [30, 2000]
std = [5, 900]
correlation = [[1.0], [0.9, 1.0]]
farthest = 2.5
[export]
hold_s = 5
fade_s = 20
""",
    "small": SMALL + "[export]\nhold_s = 10\nfade_s = 30\nstuck_s = 120\n",
    "default": SMALL,
    "friction": """[correction]
displacement = "displacement_x_um"
[[correction.channel]]
name = "line"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 400
temperature_C = 20
gain = { slope_um_W = 0.5, offset_um = 10 }
time_constant = { slope_min_W = -0.6, offset_min = 60 }
[export]
hold_s = 10
fade_s = 30
limit_um = 40
unit = "counts"
plausible = { speed_rpm = [0, 12000] }
fastest_per_s = { speed_rpm = 3000 }
""",
    "six": six_channels(),
}


def write_models(folder):
    if not os.path.isdir(folder):
        os.makedirs(folder)
    for name in ("friction.csv", "K.csv", "T.csv"):
        shutil.copy(os.path.join(PARTS, name), folder)
    for name, text in MODELS.items():
        with open(os.path.join(folder, name + ".toml"), "w") as out:
            out.write(text)
    print(" ".join(sorted(MODELS)))
    return 0
