// Grades of oil: ISO 3448 gives the viscosity at 40 °C; that at 100 °C is of an oil of viscosity index 100 (ISO 2909), which is assumed.
const index100: [number, number][] = [
  [5, 1.7],
  [7, 2.1],
  [10, 2.7],
  [15, 3.4],
  [22, 4.3],
  [32, 5.4],
  [46, 6.8],
  [68, 8.7],
  [100, 11.4],
  [150, 15],
  [220, 19.4],
];

export const grades = index100.map(([grade]) => `VG ${grade}`);

/// [mm²/s] at 40 and 100 °C of "VG 32", "ISO VG 32" or "32".
export function viscosities(grade: string): [number, number] | undefined {
  const found = /^\s*(?:iso)?\s*(?:vg)?\s*(\d+)\s*$/i.exec(grade);
  return found ? index100.find(([g]) => g === Number(found[1])) : undefined;
}
