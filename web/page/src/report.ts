// What the workbench takes of the page of reports.
export { drawNew, saveBlob } from '../../../report/page/src/figure';
export { choices, FitView, misfitMap, parity, residuals } from '../../../report/page/src/fit_rows';
export { detectable, effectNodes, plan } from '../../../report/page/src/diagnosis';
export { ladder, noiseSources } from '../../../report/page/src/ladder';
export { record } from '../../../report/page/src/record';
export { field, overTimeSection } from '../../../report/page/src/record_parts';
export { modes } from '../../../report/page/src/modes';
export { sectionFigure } from '../../../report/page/src/section_view';
export { spindleRun } from '../../../report/page/src/spindle_run';
export { spindleSteady } from '../../../report/page/src/spindle_steady';
export { RecordView } from '../../../report/page/src/record_view';
export { overSpeed } from '../../../report/page/src/over_speed';
export { grid, notes, section } from '../../../report/page/src/page';
export { axisTitle, capital, dash, el, number, plain, printed, probability, quantity, unitOfKey, unitText, valueList } from '../../../report/page/src/text';
export { verdicts } from '../../../report/page/src/verdicts';
