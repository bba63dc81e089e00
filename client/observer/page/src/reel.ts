// The frames that can be stepped through: the last ones as they came, and before them those that the
// observer has on disk.
import { historyOf, pastFrame } from "./api";
import type { HistoryList, Seen } from "./types";

const MAX_KEPT = 30;
const REFRESH_MS = 5000;
const FRESH_MS = 1000; // a list of that age need not be fetched again for a click
const SAME_US = 2e6; // so near to a frame that is here the history has the same, or such as it
const NONE: HistoryList = { minutes: 0, problem: "", shortage: "", ids: [], objects: [], problems: [] };

function nearestOf(moments: number[], time: number): number {
  return moments.reduce((best, each) => (Math.abs(each - time) < Math.abs(best - time) ? each : best));
}

// Of a fast robot the history has not all frames: which one it gives instead of what is shown; empty
// where it is that.
export function nearestInstead(shown: Seen | null, answeredAtMs: number): string {
  const later = answeredAtMs - Number(shown?.line.answered_at_ms);
  if (!later) return "";
  const seconds = (Math.abs(later) / 1000).toFixed(2);
  return `the history does not hold the frame that was shown: this is the nearest, ${seconds} s ${later < 0 ? "before" : "after"} it`;
}

export class Reel {
  history = NONE;
  onShow: (seen: Seen) => void = () => {};
  onHistory: () => void = () => {};
  private readonly kept: Seen[] = [];
  private seen: Seen | null = null; // what is shown
  private wanted = 0; // of the history, while it is fetched
  private sought = 0; // the time that was asked for last
  private fetching = false;
  private listing: Promise<void> | null = null; // while the list of the history is fetched
  private listedAt = 0; // 0: never yet
  private readonly timer: number;
  private readonly onSeen = () => this.refreshIfSeen();
  stopped = false;

  constructor(
    private readonly robot: string,
    private readonly hasHistory: boolean,
    private readonly withDepth: () => boolean,
  ) {
    this.timer = window.setInterval(this.onSeen, REFRESH_MS);
    document.addEventListener("visibilitychange", this.onSeen);
    void this.refresh();
  }

  close(): void {
    clearInterval(this.timer);
    document.removeEventListener("visibilitychange", this.onSeen);
  }

  get isListed(): boolean {
    return this.listedAt > 0;
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
    this.wanted = this.sought = 0;
    if (on) void this.refresh();
    else if (this.kept.length > 0) this.show(this.kept[this.kept.length - 1]);
  }

  // One frame on, or back.
  async step(by: number): Promise<void> {
    this.sought = 0;
    if (this.place() + by < 0) await this.freshList(); // what is older may not be known yet
    const moments = this.moments();
    if (moments.length > 0) this.goTo(moments[Math.min(moments.length - 1, Math.max(0, this.place() + by))]);
  }

  // To the frame that came nearest to this time: of what is known at once, and then of what the
  // history holds by now.
  async seek(time: number): Promise<void> {
    this.sought = time;
    if (this.isListed) this.goNear(time);
    await this.freshList();
    if (this.sought === time) this.goNear(time);
  }

  // To the oldest one, or the newest.
  seekEnd(isNewest: boolean): Promise<void> {
    return this.seek(isNewest ? Number.MAX_SAFE_INTEGER : 1);
  }

  // To the frame of the history that is nearest to what is shown; false where there is none.
  async toPast(): Promise<boolean> {
    this.sought = 0;
    await this.refresh();
    const { ids } = this.history;
    if (ids.length === 0) return false;
    this.wanted = nearestOf(ids, this.seen?.line.came_at_us ?? 0);
    await this.fetch();
    return true;
  }

  // Once more, with what is wanted of it now.
  again(): void {
    if (!this.seen?.past) return;
    this.wanted = this.seen.line.id;
    void this.fetch();
  }

  refresh(): Promise<void> {
    this.listing ??= this.list().finally(() => (this.listing = null));
    return this.listing;
  }

  private refreshIfSeen(): void {
    if (!document.hidden) void this.refresh();
  }

  private async list(): Promise<void> {
    if (!this.hasHistory) return;
    const list = await historyOf(this.robot).catch(() => null); // the page says elsewhere what is away
    if (!list) return;
    this.history = list;
    this.listedAt = Date.now();
    this.onHistory();
  }

  private async freshList(): Promise<void> {
    if (Date.now() - this.listedAt > FRESH_MS) await this.refresh();
  }

  // Oldest first: the frames that are here, and of the history what is older than they are, and what
  // came while none came here.
  private moments(): number[] {
    const kept = this.kept.map((each) => each.line.came_at_us);
    let next = 0; // of them, which is not before the one of the history
    const others = this.history.ids.filter((id) => {
      while (next < kept.length && kept[next] < id) ++next;
      return next === 0 || Math.min(id - kept[next - 1], (kept[next] ?? Infinity) - id) > SAME_US;
    });
    return [...others, ...kept].sort((a, b) => a - b);
  }

  // Where among them that is which is shown, or will be.
  private place(): number {
    const now = this.wanted || this.seen?.line.came_at_us || 0;
    const moments = this.moments();
    let at = moments.length - 1;
    while (at > 0 && moments[at] > now) --at;
    return at;
  }

  private goNear(time: number): void {
    const moments = this.moments();
    if (moments.length > 0) this.goTo(nearestOf(moments, time));
  }

  private goTo(moment: number): void {
    const kept = this.kept.find((each) => each.line.came_at_us === moment);
    this.wanted = kept ? 0 : moment;
    if (kept) this.show(kept);
    else if (this.seen?.line.came_at_us !== moment) void this.fetch();
    else this.wanted = 0;
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
