// The same colour for the same label in pictures, tables and clouds of the page (overlays of the
// command line have others); told apart by people who see fewer colours, too.
const COLORS: [number, number, number][] = [
  [230, 159, 0],
  [86, 180, 233],
  [0, 158, 115],
  [240, 228, 66],
  [0, 114, 178],
  [213, 94, 0],
  [204, 121, 167],
  [148, 103, 189],
  [23, 190, 207],
  [188, 189, 34],
];

export const NUM_COLORS = COLORS.length;

export function colorOf(label: number): [number, number, number] {
  return COLORS[(label - 1) % COLORS.length];
}

export function cssOf(label: number, alpha = 1): string {
  const [r, g, b] = colorOf(label);
  return `rgba(${r}, ${g}, ${b}, ${alpha})`;
}
