"""Makes the page of the documents that --json prints: keys from runs of the commands, meanings from the table here.

Called by scripts/docs_pages.py. A meaning whose key no run prints stops the build, so that the table cannot grow old.
"""

import json
import os
import re
import subprocess
import tempfile
from pathlib import Path

# What a reader of the documents needs first: models of which the commands below are asked.
SETUP = """
raceway new "S 6014 C" --law palmgren -o my.toml
sed '/^law/,$d' data/examples/7014.toml > contact.toml; echo 'law = "contact"' >> contact.toml
sed '/^outer_conformity/a inner_shoulder_diameter_mm = 84\\nouter_shoulder_diameter_mm = 96' data/examples/7014.toml > shoulders.toml
raceway calibrate rig/model.toml rig/train.csv -o fitted.toml
raceway displacement data/spindles/two_against_one.toml --speed 0:10000:500 -o curve.csv
raceway identify data/chain/machine.toml data/chain/calibration.csv -o machine_part.toml
raceway join data/chain/true_spindle.toml machine_part.toml -o sum.toml
printf '[correction]\\ndisplacement = "displacement_z_um"\\ntolerance_um = 2\\n' > bare.toml
cat > polynomials.toml <<'END'
[correction]
displacement = "displacement_z_um"
sampling_s = 1
[[correction.channel]]
input = "front_temperature_C"
numerator = [16.0005, -15.9975]
denominator = [1, -0.99983]
END
sed 's/^end_mm = 300.0/end_mm = 180.0/' data/spindles/externally_driven.toml > circuits.toml
cat >> circuits.toml <<'END'
[[coolant.circuit]]
name = "rear_jacket"
flow_l_min = 4
diameter_mm = 140
channel_width_mm = 10
channel_depth_mm = 4
pitch_mm = 14
start_mm = 190
end_mm = 300
END
awk 'BEGIN { print "time_s,front_temperature_C,displacement_z_um"; for (k = 0; k < 400; k++) print k "," 20 + (k % 50) / 10 "," k / 10 }' > even.csv
"""
# Commands whose documents together have the keys of a kind.
DOCUMENTS = {
    "solve": [
        "solve contact.toml --speed 10000 --axial-load 600",
        "solve shoulders.toml --speed 10000 --axial-load 600",
        "solve fitted.toml --speed 10000 --axial-load 600 --band",
    ],
    "solve, cylindrical rollers": ["solve data/examples/n1012.toml --speed 6000 --radial-load 2000"],
    "table": [
        "table fitted.toml --speed 6000 --axial-load 300 --band",
        "table contact.toml --speed 6000 --axial-load 300",
        "table data/spindles/two_against_one.toml --speed 6000",
        "table data/examples/n1012.toml --speed 6000 --radial-load 2000",
    ],
    "displacement": ["displacement data/spindles/two_against_one.toml --speed 6000"],
    "sensitivity": ["sensitivity my.toml --speed 8000 --axial-load 300", "sensitivity my.toml --speed 8000 --axial-load 300 --global 64"],
    "check": ["check rig/model.toml rig/train.csv"],
    "check, record over time": ["check data/corrections/exact/correction.toml data/corrections/exact/train.csv", "check polynomials.toml even.csv"],
    "compare": [
        "compare rig/model.toml rig/test.csv --tolerance 2Nmm",
        "compare data/measurements/flywheel.toml data/measurements/flywheel_unloaded.csv data/measurements/flywheel_unloaded_5_28.csv",
    ],
    "compare, record over time": ["compare data/corrections/exact/correction.toml data/corrections/exact/test.csv"],
    "calibrate": [
        "calibrate rig/model.toml rig/train.csv --profile",
        "calibrate tests/cli/everyday/logger-drag/model.toml tests/cli/everyday/logger-drag/train.csv",
        "calibrate sum.toml data/chain/verification.csv --until 20h",
    ],
    "diagnose": [
        "diagnose rig/model.toml rig/train.csv --tolerance 2Nmm",
        "diagnose data/spindles/two_against_one.toml data/spindles/ring_growth_sweep.csv",
        "diagnose tests/cli/everyday/law-skf/model.toml tests/cli/everyday/law-skf/train.csv",
        "diagnose tests/cli/everyday/scatter-with-speed/model.toml tests/cli/everyday/scatter-with-speed/train.csv",
        "diagnose tests/cli/everyday/logger-states/model.toml tests/cli/everyday/logger-states/train.csv",
    ],
    "diagnose, record over time": ["diagnose data/corrections/ambient/correction.toml data/corrections/ambient/train.csv"],
    "add": ["add rig/model.toml lubricant-drag --data rig/train.csv"],
    "identify": [
        "identify data/corrections/exact/correction.toml data/corrections/exact/train.csv --validate data/corrections/exact/test.csv",
        "identify bare.toml data/corrections/exact/train.csv --lags auto",
    ],
    "identify --baseline arx": ["identify data/corrections/exact/correction.toml data/corrections/exact/train.csv --baseline arx"],
    "correct": ["correct data/corrections/exact/correction.toml data/corrections/exact/test.csv"],
    "fit-law": ["fit-law curve.csv"],
    "calibrate-sensor": ["calibrate-sensor data/measurements/torque_weights.csv"],
    "spindle": [
        "spindle data/spindles/externally_driven.toml --speed 6000 --steady --assumptions",
        "spindle data/spindles/externally_driven.toml --speed-profile data/spindles/day.csv",
        "spindle circuits.toml --speed 6000 --steady",
    ],
    "deflection": ["deflection data/spindles/externally_driven.toml --force 1000 --speed 8000"],
    "modes": ["modes data/spindles/externally_driven.toml --speed 6000 --unbalance 5 --damping 0.03"],
    "step-response": ["step-response data/spindles/externally_driven.toml --speed 4000,6000,8000"],
    "effects": ["effects windage"],
    "keys": ["keys conformity"],
    "bearings": ["bearings 7014"],
}
# What does not follow from the name of a key. The key of a kind; "any" holds for all kinds.
MEANINGS = {
    "any": {
        "notes": "notes and warnings on stderr, of the record and the model",
        "judgement": "limits that the answer passes",
        "report.status": "no_equilibrium comes with certain: true if no equilibrium exists, false if none was found",
        "dwells.rows": "rows of the file; lines are the first of each dwell",
        "noise.log_determinant": "ln det(2 pi S) of the noise that weighs the readings",
        "noise.estimated_rms": "where the noise is not known: as calibrate and diagnose find it in these rows",
        "noise.growth": "of scatter that grows with speed; relative is then the one at the highest speed",
        "noise.run_share": "of the scatter, common to a run; dwell_share: common to the pieces of a dwell, where it is found",
        "fit_percent": "100 (1 - |y - y'| / |y - mean y|); 100 is perfect, 0 no better than the mean",
        "bias": "mean of prediction minus reading",
        "correlation_time_s": "of the residual",
        "peak_to_peak_um": "|max| + |min| of the residue",
        "residue_min_um": "of measured minus predicted",
        "residue_max_um": "of measured minus predicted",
        "within_tolerance": "every channel is within its tolerance",
        "tolerance_Nmm": "in the unit of the reading",
        "rmse_held_out_Nmm": "of the refitted model; in the unit of the reading",
        "order_tried[].order": "numbers of lags that were tried, of each channel",
        "trust.verdict": "good, within-range, do-not-use or unknown",
        "band.level": "probability of the band; the keys with band in their name are half widths",
        "hold_out[].left_out": "what the parts left out have in common",
    },
    "solve": {
        "shoulder": "null without shoulder diameters",
        "balls[].pitch_angle_deg": "of the ball's axis to the bearing's",
        "balls[].inner_contact_angle_deg": "null where the inner race is lost",
        "balls[].inner.lambda": "law contact: film over roughness; null where that race is lost",
        "stiffness.matrix": "5x5, SI, order x, y, z, theta_y, theta_z",
        "life.Lnm_h": "null with balls that are not of steel, for which ISO 281 has no a_ISO, and at standstill",
        "holding_coefficient": "law contact: friction over contact load that film and asperities can give",
        "friction_torque_band_Nmm": "with --band",
    },
    "solve, cylindrical rollers": {
        "stiffness.matrix": "4x4, SI, order y, z, theta_y, theta_z",
        "report.status": "also loose: nothing touches the inner ring, without load and preload",
    },
    "table": {
        "rows[].status": "as of solve; the columns are those of the CSV",
        "rows[].load_Nmm": "parts of the torque, one ID_Nmm per effect; with the law skf sliding and rolling moment, with table table_Nmm in their place",
        "rows[].rolling_Nmm": "law contact: in place of load_Nmm and viscous_Nmm",
        "rows[].inner_contact_angle_min_deg": "smallest and largest over the balls in contact",
        "rows[].inner_contact_pressure_MPa": "largest Hertz pressure",
        "rows[].lost_balls": "balls without inner contact",
        "rows[].axial_displacement_um": "of the inner ring, from the no-load position at standstill; of a shaft from standstill under the same load",
        "rows[].radial_displacement_y_um": "along the radial load",
        "rows[].film_min_um": "law contact: thinnest film",
        "rows[].lambda_min": "thinnest film over roughness",
        "rows[].kappa": "viscosity over the reference viscosity of ISO 281",
        "rows[].slip_mean_m_s": "weighted by pressure",
        "rows[].inner_ring_heat_W": "of the contacts of the inner ring",
        "rows[].life_h": "ISO/TS 16281",
        "rows[].axial_position_um": "of a shaft, from the mounted state without load; over the load at 0 rpm the load-deflection curve",
        "rows[].front_1_axial_load_N": "of each bearing of a shaft",
        "rows[].friction_torque_band_Nmm": "with --band",
    },
    "sensitivity": {
        "predictions[].data[].name": "sorted by change, largest first",
        "predictions[].data[].origin": "file, default, catalogue or asked",
        "global.failed": "with first_failed {why, data} where some have no value",
        "predictions[].data[].global.first": "with --global; null where it was not sampled",
    },
    "check": {"effects[].ruled_out": "by the supply of lubricant"},
    "check, record over time": {
        "repeatability": "null where no reading was repeated, else {two_sigma_um, degrees_of_freedom, stops [{time_s, readings, mean_um, two_sigma_um}]}",
        "polynomials[].channel": "the first of them stands at the top, too",
    },
    "compare": {
        "worst_rows[].sigmas": "residual over the noise, null where it is not known",
        "where[].variable": "sorted worst first",
        "records[].record": "of several files",
    },
    "calibrate": {
        "parameters.NAME.held": "left at its start, or at its prior",
        "parameters.NAME.prior.value": "of a correction with [correction.prior]",
        "parameters.NAME.profile.from": "with --profile",
        "profile.rise": "of chi square at the ends of the interval",
        "profile.refits": "of all intervals together",
    },
    "diagnose": {
        "headline": "for a person",
        "sentence": "the same with its numbers",
        "effects[].gain": "fall of -2 ln L less ln N for each free shape",
        "effects[].parameters.NAME.from": "95 % interval of the size",
        "effects[].parameters.NAME.is_size": "it gives the effect its size",
        "effects[].base_parameters.NAME.before": "without this effect",
        "explanation_fits[].gain": "of each of explanations, a set as a whole",
        "base_parameters.NAME.before": "before and after alike where nothing is named",
        "correlation.names": "of the first explanation; of the model where there is none",
        "other_bases[].id": "other base laws that were tried, the best first",
        "other_bases[].fitted_form": "true: the exponents are fitted too, so this base describes the data without explaining them",
        "given_other_base.verdict": "with the first of them, where it is worth it",
        "suggested_measurements[].difference_in_sigma": "of the explanations that the point separates",
        "shape.torque_Nmm": "where nothing in the catalogue explains the misfit",
    },
    "diagnose, record over time": {
        "effects[].channel": "or axis: where one of its kind acts; ids are those of the catalogue",
        "verdict": "with not-in-catalogue also shape {when [[from, to], ...], period_s, time_constant_s} in s",
    },
    "identify": {"validation": "null without --validate", "ahead[].from_s": "of a bank of lags; rmse_held_out_um is then the mean of ahead"},
    "calibrate-sensor": {"hysteresis.largest_percent": "of the signal of the whole range, as all per cents here"},
    "spindle": {
        "steady[].coolant.velocity_m_s": "of a steady state",
        "steady[].circuits[].heat_W": "of each circuit where [[coolant.circuit]] adds one; heat_to_coolant_W is the sum",
        "steady[].seats[].on_shaft.pressure_MPa": "0 of a loose seat, null where its conductance is given",
        "steady[].surfaces[].pressure_MPa": "of a screwed flange and of clamped rings, else null",
        "steady[].surfaces[].heat_W": "out of the spindle, through the gap to the housing, or from a clamped ring to its neighbour; null of shoulders and collars",
        "steady[].shaft[].axial_displacement_um": "relative to the flange, from the nose to the rear end",
        "steady[].stress.largest.part": "shaft, inner_ring or outer_ring; place of the largest von Mises stress; tension is positive",
        "steady[].stress.sections[].bearing": "bearing of the ring or of the seat on the shaft; null elsewhere",
        "steady[].stress.sections[].at[].radius_mm": "from the bore to the surface",
        "highest_front_force.force_N": "of a programme",
        "rows_reached": "an early end stands behind these as a row of its own",
        "assumptions.most[].name": "with --assumptions",
    },
    "effects": {
        "acts_on": "quantities that it changes; of an effect with two forms effects [...] has both",
        "acts_in": "kinds of models where it does: rig, shaft, spindle",
        "supplies": "supplies of lubricant with which it can be at work; any where empty",
        "within_contact_law": "what stands for it in the law contact, which then takes no such effect; null where it does",
    },
    "keys": {
        "keys[].kind": "number, text, true or false, list, table",
        "keys[].from": "null of what is no number",
        "keys[].only": "models that have the key, such as law skf, spindle; null: all models",
    },
}
# Objects whose names are those of parameters, data or files, and documents that stand within another one.
OF_NAMES = {"parameters", "base_parameters"}
WITHIN = {"baseline": "compare", "before": "compare", "after": "compare", "metrics": "compare, record over time", "calibration": "calibrate"}


def flat(value, path, keys):
    """Adds the keys below a value with an example each: a.b, of lists a[].b."""
    if isinstance(value, dict):
        if path.split(".")[-1] in OF_NAMES and value and all(isinstance(one, dict) for one in value.values()):
            for one in value.values():
                flat(one, path + ".NAME", keys)
            return
        for key, one in value.items():
            flat(one, f"{path}.{key}" if path else key, keys)
        if not value:
            keys.setdefault(path, "{}")
    elif isinstance(value, list) and any(isinstance(one, dict) for one in value):
        for one in value:
            flat(one, path + "[]", keys)
    else:
        known = keys.get(path)
        if known in (None, "null", "[]") or (known == '""' and value):
            keys[path] = json.dumps(value, ensure_ascii=False)


def documents(root, program):
    """Keys with an example of all documents, by kind."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "raceway").symlink_to(program)
        for name in ("data", "tests"):
            (work / name).symlink_to(root / name)
        (work / "rig").symlink_to(root / "tests/hidden_effect/rigs/dev-03")
        environment = {**os.environ, "PATH": f"{work}:{os.environ['PATH']}"}

        def run(line):
            return subprocess.run(["bash", "-c", line], cwd=work, env=environment, capture_output=True, text=True)

        done = run("set -e" + SETUP)
        if done.returncode:
            raise SystemExit(f"docs_json: {done.stderr}")
        for kind, lines in DOCUMENTS.items():
            keys = found[kind] = {}
            for line in lines:
                answer = run(f"raceway {line} --json")
                if answer.returncode:
                    raise SystemExit(f"docs_json: raceway {line}: {answer.stderr}{answer.stdout[:500]}")
                flat(json.loads(answer.stdout), "", keys)
    return found


def shown(kind, keys, found):
    """Keys of a kind without those that stand in every document, or in the document of another command."""
    for key, example in keys.items():
        top, _, rest = key.partition(".")
        if key == "format" or key.startswith("said") or rest in found.get(WITHIN.get(top), ()):
            continue
        yield key, example


def tails(key):
    """Ends of a key: a.b[].c, b[].c, c; of a list also its own name."""
    parts = key.split(".")
    ends = [".".join(parts[at:]) for at in range(len(parts))]
    return ends + [part.removesuffix("[]") for part in parts]


def meaning_of(kind, key):
    own, common = MEANINGS.get(kind, {}), MEANINGS["any"]
    return own.get(key) or next((common[tail] for tail in tails(key)[: key.count(".") + 1] if tail in common), "")


def note_codes(root):
    """(code, kind, meaning) of each note, from record/note.h."""
    text = (root / "record/note.h").read_text(encoding="utf-8")
    found = re.findall(r'NoteCode \w+\{"([\w-]+)",\s*NoteKind::(\w+),\s*((?:"[^"]*"\s*)+)\}', text)
    return [(code, kind, "".join(re.findall('"([^"]*)"', meaning))) for code, kind, meaning in found]


def page(root, program, for_table):
    """Text of the page, and the codes of notes, which must be found on it."""
    found = documents(root, program)
    wrong = [f"{kind}: {key}" for kind, meanings in MEANINGS.items() if kind != "any" for key in meanings if key not in found[kind]]
    known = {tail for keys in found.values() for key in keys for tail in tails(key)}
    wrong += [f"any: {key}" for key in MEANINGS["any"] if key not in known]
    if wrong:
        raise SystemExit("docs_json: no document has " + ", ".join(wrong))
    text = "# Documents of --json\n\nThe keys that each command prints with `--json`, with the value of an example. A key that does not apply to a\n"
    text += "question is missing or `null`. Rules for all of them: [files](../docs/files.md#results-json).\n\n"
    for kind, keys in found.items():
        text += f"## {kind}\n\n```console\n" + "".join(f"$ raceway {line} --json\n" for line in DOCUMENTS[kind]) + "```\n\n"
        text += "| key | example | meaning |\n| --- | --- | --- |\n"
        for key, example in shown(kind, keys, found):
            example = example if len(example) <= 40 else example[:37] + "..."
            text += f"| `{key}` | {for_table(example)} | {for_table(meaning_of(kind, key))} |\n"
        for top, other in WITHIN.items():
            if any(key.startswith(top + ".") for key in keys):
                text += f"\n`{top}` also has the keys of [{other}](#{other.replace(',', '').replace(' ', '-')}).\n"
        text += "\n"
    codes = note_codes(root)
    text += "## Codes of notes\n\nThe `code` and `kind` of `said`; programs go by them.\n\n| code | kind | about |\n| --- | --- | --- |\n"
    text += "".join(f"| `{code}` | {kind} | {for_table(meaning)} |\n" for code, kind, meaning in codes)
    return text, [code for code, _, _ in codes]
