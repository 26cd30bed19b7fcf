"""A component of HAL with pins, clock and sleep of a test: python3 hal.py FILE.comp > FILE.c.

What halcompile makes of a .comp file, as far as the component uses it. Between two rounds of its
loop the test reads the next line of its script; see control_test.cpp.
"""
import re
import sys

text = open(sys.argv[1]).read()
declarations, code = text.split("\n;;\n", 1)
declarations = re.sub(r'""".*?"""', '""', declarations, flags=re.S)
types = {"float": "double", "bit": "int", "unsigned": "unsigned", "signed": "int"}
pins = []
for statement in re.findall(r'^(?:[^";]|"[^"]*")*;', declarations, flags=re.M):
    words = statement.split()
    if words[0] == "pin":
        default = re.search(r"=\s*([0-9.]+)", statement.split('"')[0])
        pins.append((words[1], types[words[2]], words[3], default.group(1) if default else "0"))
    elif words[0] == "option":
        assert statement in ("option userspace yes;", "option singleton yes;",
                             "option userinit yes;"), statement
    else:
        assert words[0] in ("component", "description", "license"), statement
assert 'license "' in declarations

print("#define _POSIX_C_SOURCE 200809L\n#define _DEFAULT_SOURCE\n#include <stdlib.h>")
print("#include <string.h>\n#include <unistd.h>\n#include <stdio.h>\n#include <time.h>")
print("struct pins {%s};" % " ".join("%s %s;" % (kind, name) for _, kind, name, _ in pins))
print("static struct pins all = {%s};" % ", ".join(default for _, _, _, default in pins))
for direction, kind, name, _ in pins:
    # What comes in cannot be written.
    print("#define %s (%s__comp_inst->%s)" % (name, "0+" if direction == "in" else "", name))
print("#define FOR_ALL_INSTS() for (struct pins *__comp_inst = &all; __comp_inst; __comp_inst = 0)")
print("static void next_round(unsigned pause);\nstatic double test_time;")
print("static int test_clock(struct timespec *t) {")
print("  t->tv_sec = (time_t)test_time;")
print("  t->tv_nsec = (long)((test_time - (double)t->tv_sec) * 1e9 + 0.5);\n  return 0;\n}")
print("#define usleep(pause) next_round(pause)")
print("#define clock_gettime(which, t) test_clock(t)")
print(code)
inputs = [name for direction, kind, name, _ in pins
          if direction == "in" and name not in ("enable", "reset", "zero", "interval")]
outputs = [name for direction, kind, name, _ in pins if direction == "out" and kind == "double"]
for _, _, name, _ in pins:
    print("#undef " + name)
print("static void next_round(unsigned pause) {\n  static int called;\n  char word[16];")
print("  if (pause < 10000) exit(4);")
print("  if (called) { %s printf(\"%%u\\n\", all.status_bits); }" %
      " ".join('printf("%%.17g ", all.%s);' % name for name in outputs))
print("  called = 0;\n  all.reset = all.zero = all.enable = 0;")
print("  if (scanf(\"%15s\", word) != 1) exit(0);")
print("  if (strcmp(word, \"restart\") == 0) {\n    write_state();")
print("    memset(&machine, 0x55, sizeof machine);\n    last_call = 1e9;")
print("    char *arguments[] = {(char *)\"machine\", (char *)state_file};")
print("    userinit(2, arguments);\n    return;\n  }")
print("  if (strcmp(word, \"reset\") == 0) { all.reset = 1; return; }")
print("  if (strcmp(word, \"zero\") == 0) {\n    machine_set_zero(&machine);\n    return;\n  }")
print("  if (scanf(\"%lf\", &test_time) != 1) exit(3);")
for name in inputs:
    print("  { double x; if (scanf(\"%%lf\", &x) != 1) exit(3); all.%s = x; }" % name)
print("  all.enable = called = 1;\n}")
print("int main(int argc, char **argv) { userinit(argc, argv); user_mainloop(); }")
