% raceway_table in Octave: numbers of the command, and errors that leave the interpreter alive.
% Run by scripts/octave: octave-cli raceway_table_test.m PROGRAM MODEL FOLDER-OF-THE-MEX-FILE

arguments = argv ();
program = arguments{1};
model = arguments{2};
addpath (arguments{3});

% An error with this identifier and these words, and Octave goes on.
function refused (words, varargin)
  try
    raceway_table (varargin{:});
  catch e
    assert (e.identifier, "raceway:input");
    assert (any (strfind (e.message, words)), e.message);
    return;
  end
  error ("not refused: %s", words);
end

speed = [1000; 2500; 4000; 12000];
axial = [50 300 900];
radial = [0 60];
temperature = [30 70];
[values, columns, status] = raceway_table (model, speed, axial, radial, temperature);
assert (size (values), [4, 3, 2, 2, numel(columns)]);
assert (size (status), [4, 3, 2, 2]);
assert (class (status), "int32");
assert (all (status(:) == 0));

[failed, csv] = system (sprintf (["'%s' table '%s' --speed 1000,2500,4000,12000 " ...
  "--axial-load 50,300,900 --radial-load 0,60 --temperature 30,70 --format plain -o - --quiet " ...
  "2>/dev/null"], program, model));
assert (failed, 0);
lines = strsplit (strtrim (csv), "\n");
names = strsplit (lines{1}, ",");
for c = 5:numel (names) - 1  % between inputs and status
  column = find (strcmp (strrep (columns, "-", "_"), names{c}));
  assert (numel (column), 1);
  mine = values(:, :, :, :, column)(:);
  for i = 1:numel (mine)
    cells = strsplit (lines{i + 1}, ",");
    told = str2double (cells{c});
    assert (mine(i), told, 1e-11 * abs (told));  % 12 digits are printed
  end
end

% What is left out or empty is the model's own: 40 C, no radial load.
[own, ~] = raceway_table (model, 1000, 300);
assert (own, raceway_table (model, 1000, 300, [], []));
assert (own(1), raceway_table (model, 1000, 300, 0, 40)(1));

% What is printed without outputs is what is returned.
printed = evalc ("raceway_table (model, [1000 4000], 300);");
torque = raceway_table (model, [1000 4000], 300)(:, 1, 1, 1, 1);
assert (any (strfind (printed, sprintf ("%10g %10.4g\n", 4000, torque(2)))), printed);

% A point without balance is NaN and a warning.
lastwarn ("");
evalc ("[v, ~, s] = raceway_table (model, [0 1000], [0 300]);");  # which prints the warning
[words, identifier] = lastwarn ();
assert (identifier, "raceway:status");
assert (any (strfind (words, "states have not converged: no_equilibrium; the first has index 0")), words);
position = find (strcmp (columns, "axial_displacement_um"));
assert (isnan (v(1, 1, 1, 1, position)));
assert (! isnan (v(2, 2, 1, 1, position)));
assert (s(1, 1) != 0 && s(2, 2) == 0);

% Wrong files, types and shapes.
refused ("none.toml: no such file", "none.toml", 1000);
refused ("is a directory", "/", 1000);
refused ("speed_rpm[1] = nan rpm: must be from 0 to 1000000 rpm", model, [1000 NaN], 300);
refused ("axial_load_N[0] = -5 N: must be from 0", model, 1000, -5);
refused ("speed_rpm is missing", model, [], 300);
refused ("axial_load_N is missing", model, 1000);
refused ("model_file: must be the name of a file", 12, 1000);
refused ("model_file: must be the name of a file", "", 1000);
refused ("model_file: must be the name of a file", {model}, 1000);
refused ("model_file: must be the name of a file", [model; model], 1000);
refused ("speed_rpm: must be an array of real doubles", model, "fast", 300);
refused ("speed_rpm: must be an array of real doubles", model, {1000}, 300);
refused ("speed_rpm: must be an array of real doubles", model, single (1000), 300);
refused ("speed_rpm: must be an array of real doubles", model, int32 (1000), 300);
refused ("axial_load_N: must be an array of real doubles", model, 1000, 300i);
refused ("axial_load_N: must be an array of real doubles", model, 1000, sparse (300));
refused ("temperature_C: must be an array of real doubles", model, 1000, 300, 0, struct ());
refused ("raceway_table (model_file, speed_rpm", model);
refused ("raceway_table (model_file, speed_rpm");
refused ("raceway_table (model_file, speed_rpm", model, 1, 2, 3, 4, 5);
% Text that is no model.
wrong = [tempname() ".toml"];
file = fopen (wrong, "w");
fputs (file, "[bearing]\nball_count = -3\n");
fclose (file);
[~, told] = system (sprintf ("'%s' table '%s' --speed 1000 2>&1", program, wrong));
refused (strtrim (told), wrong, 1000);
unlink (wrong);

% What docs/c.md shows runs.
shown = regexp (fileread ("docs/c.md"), '^>> (.*?)$', "tokens", "lineanchors");
assert (numel (shown) >= 3);
for i = 1:numel (shown)
  printed = evalc (shown{i}{1});
end
assert (size (torque), [13, 3]);
assert (any (strfind (printed, "Friction torque [N mm]")), printed);

% A thousand models leave the memory as it is but for 20 MB.
function kB = resident ()
  kB = str2double (regexp (fileread ("/proc/self/status"), 'VmRSS:\s*(\d+)', "tokens"){1}{1});
end
before = resident ();
for i = 1:1000
  v = raceway_table (model, 1000, 300, [], 40);
  try
    raceway_table (model, -1, 300);
  catch
  end
end
assert (resident () - before < 20000);
disp ("Octave: all as it should be");
