// A host process with decimal commas: loaded before a program, it sets the locale of the
// environment, as spreadsheets and office programs do for the libraries that they load.
#include <clocale>

[[gnu::constructor]] static void take_locale() { std::setlocale(LC_ALL, ""); }
