// Lists below the pictures of a diagnosis and of an addition: fitted numbers, and effects that could not be tested.
import type { Diagnosis, Size } from './document';
import { number, unitText, valueList } from './text';

export function parameterList(title: string, parameters: Record<string, Size>, digits = 4): HTMLElement {
  return valueList(
    title,
    ['parameter', 'value', 'std error', 'unit'],
    Object.entries(parameters).map(([name, p]) => [name, number(p.value, digits), number(p.std, 2), unitText(p.unit)]),
  );
}

/// Base parameters before and after the explanation, if there is one.
export function shiftList(d: Diagnosis): HTMLElement {
  return valueList(
    'Parameters of the model, without and with the missing effects',
    ['parameter', 'without', 'with', 'std error', 'unit'],
    (d.explanations.length ? Object.entries(d.base_parameters) : []).map(([name, p]) => [name, number(p.before), number(p.after), number(p.std, 2), unitText(p.unit)]),
  );
}

export function notTestableList(d: Diagnosis): HTMLElement | undefined {
  if (!d.not_testable.length) return undefined;
  return valueList(
    'Effects that these data cannot show',
    ['effect', 'reason'],
    d.not_testable.map((n) => [n.id, n.missing]),
  );
}
