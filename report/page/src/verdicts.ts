// Verdicts of a diagnosis as they stand on a badge, and its kind.
export const verdicts: Record<string, [string, string]> = {
  'nothing-missing': ['nothing missing', 'good'],
  effect: ['one effect', 'found'],
  ambiguous: ['ambiguous', 'open'],
  'several-effects': ['several effects', 'found'],
  'effect-like': ['similar to an effect', 'open'],
  'not-in-catalogue': ['not in the catalogue', 'open'],
};
