// How often a robot sends, and how long ago that was by the observer's clock: this machine's may be
// another.
import type { RobotLine } from "./types";

const QUIET_MS = 10_000;
const LEAST_HZ = 0.1; // that can be told as frames a second

let ahead = 0; // the observer's clock, in ms

export function setClock(observerUs: number): void {
  ahead = observerUs / 1000 - Date.now();
}

// In ms since 1970.
export const observerNow = () => Date.now() + ahead;

const silenceOf = (line: RobotLine) => observerNow() - line.came_at_us / 1000;

export const isQuiet = (line: RobotLine) => silenceOf(line) > QUIET_MS;

// In the unit that people would take.
export function spanOf(ms: number): string {
  const seconds = Math.max(0, Math.round(ms / 1000));
  if (seconds < 120) return `${seconds} s`;
  return seconds < 7200 ? `${Math.round(seconds / 60)} min` : `${Math.round(seconds / 3600)} h`;
}

export function paceOf(line: RobotLine): string {
  if (isQuiet(line)) return `quiet for ${spanOf(silenceOf(line))}`;
  if (line.rate_hz === 0) return "how often is not known yet";
  return line.rate_hz < LEAST_HZ ? `one in ${spanOf(1000 / line.rate_hz)}` : `${line.rate_hz.toFixed(1)} a second`;
}
