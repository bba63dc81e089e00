// The frames that can be stepped through: the last ones as they came, and before them those that the
// observer has on disk.
import { historyOf, pastFrame } from "./api";
import type { HistoryList, Seen } from "./types";

const MAX_KEPT = 30;
const REFRESH_MS = 5000;
const NONE: HistoryList = { minutes: 0, problem: "", ids: [], objects: [], problems: [] };

export class Reel {
  history = NONE;
  onShow: (seen: Seen) => void = () => {};
  onHistory: () => void = () => {};
  private readonly kept: Seen[] = [];
  private seen: Seen | null = null; // what is shown
  private wanted = 0; // of the history, while it is fetched
  private fetching = false;
  private readonly timer: number;
  stopped = false;

  constructor(
    private readonly robot: string,
    private readonly hasHistory: boolean,
    private readonly withDepth: () => boolean,
  ) {
    this.timer = window.setInterval(() => void this.refresh(), REFRESH_MS);
    void this.refresh();
  }

  close(): void {
    clearInterval(this.timer);
  }

  get newestId(): number {
    return this.kept[this.kept.length - 1]?.line.id ?? 0;
  }

  get current(): Seen | null {
    return this.seen;
  }

  add(seen: Seen): void {
    this.kept.push(seen);
    const most = this.stopped ? 2 * MAX_KEPT : MAX_KEPT;
    while (this.kept.length > most) this.release(this.kept.shift()!);
    if (!this.stopped) this.show(seen);
  }

  stop(on: boolean): void {
    this.stopped = on;
    this.wanted = 0;
    if (on) void this.refresh();
    else if (this.kept.length > 0) this.show(this.kept[this.kept.length - 1]);
  }

  // One frame on, or back.
  step(by: number): void {
    const moments = this.moments();
    const now = this.wanted || this.seen?.line.came_at_us || 0;
    let at = moments.length - 1;
    while (at > 0 && moments[at] > now) --at;
    this.seek(moments[Math.min(moments.length - 1, Math.max(0, at + by))]);
  }

  // To the frame that came nearest to this time.
  seek(time: number): void {
    const moments = this.moments();
    if (moments.length === 0) return;
    const nearest = moments.reduce((best, each) => (Math.abs(each - time) < Math.abs(best - time) ? each : best));
    const kept = this.kept.find((each) => each.line.came_at_us === nearest);
    this.wanted = kept ? 0 : nearest;
    if (kept) this.show(kept);
    else void this.fetch();
  }

  // To the frame of the history that is nearest to what is shown; false where there is none.
  async toPast(): Promise<boolean> {
    await this.refresh();
    const now = this.seen?.line.came_at_us ?? 0;
    const nearest = this.history.ids.reduce((best, each) => (Math.abs(each - now) < Math.abs(best - now) ? each : best), 0);
    this.wanted = nearest;
    await this.fetch();
    return nearest > 0;
  }

  // Once more, with what is wanted of it now.
  again(): void {
    if (!this.seen?.past) return;
    this.wanted = this.seen.line.id;
    void this.fetch();
  }

  async refresh(): Promise<void> {
    if (!this.hasHistory) return;
    const list = await historyOf(this.robot).catch(() => null); // the page says elsewhere what is away
    if (!list) return;
    this.history = list;
    this.onHistory();
  }

  // Oldest first: of the history what is older than the frames that are here.
  private moments(): number[] {
    const first = this.kept[0]?.line.came_at_us ?? Infinity;
    return [...this.history.ids.filter((id) => id < first), ...this.kept.map((each) => each.line.came_at_us)];
  }

  // The last one that was asked for, however fast the keys are pressed.
  private async fetch(): Promise<void> {
    if (this.fetching) return;
    this.fetching = true;
    try {
      while (this.wanted) {
        const id = this.wanted;
        const seen = await pastFrame(this.robot, id, this.withDepth());
        if (this.wanted !== id) {
          seen?.picture?.close();
          continue;
        }
        this.wanted = 0;
        if (seen) this.show(seen);
      }
    } catch {
      this.wanted = 0; // the page says elsewhere that the observer is away
    } finally {
      this.fetching = false;
    }
  }

  private show(seen: Seen): void {
    const before = this.seen;
    this.seen = seen;
    if (before && before !== seen && !this.kept.includes(before)) this.release(before);
    this.onShow(seen);
  }

  private release(seen: Seen): void {
    if (seen !== this.seen) seen.picture?.close();
  }
}
