// What comes of one robot, as fast as it can be fetched: the newest frame each time.
import { answerOf, depthOf, pictureOf, RETRY_MS } from "./api";
import type { RobotLine, Seen } from "./types";

export class Live {
  listed: RobotLine | null = null; // as the list of robots has it
  onLine: (line: RobotLine) => void = () => {};
  onFrame: (seen: Seen) => void = () => {};
  private newest: RobotLine | null = null;
  private fetched = 0; // its number
  private busy = false;

  constructor(
    private readonly robot: string,
    private readonly withDepth: () => boolean,
  ) {}

  update(close: RobotLine | undefined, listed: RobotLine | undefined): void {
    this.listed = listed ?? this.listed;
    if (!close || (this.newest && close.id <= this.newest.id)) return;
    this.newest = close;
    this.onLine(close);
    void this.fetch();
  }

  close(): void {
    this.newest = null;
  }

  private async fetch(): Promise<void> {
    const line = this.newest;
    if (this.busy || !line || this.fetched === line.id) return;
    this.busy = true;
    try {
      const seen = await this.load(line);
      this.fetched = line.id;
      if (seen) this.onFrame(seen);
    } catch {
      setTimeout(() => void this.fetch(), RETRY_MS); // the page says elsewhere that the observer is away
      return;
    } finally {
      this.busy = false;
    }
    if (this.newest !== line) void this.fetch();
  }

  private async load(line: RobotLine): Promise<Seen | null> {
    const [frame, picture, depth] = await Promise.all([
      answerOf(this.robot, line.id),
      line.has_picture ? pictureOf("picture", this.robot, line.id) : null,
      this.withDepth() ? depthOf(this.robot, line.id) : null,
    ]);
    return frame ? { line, frame, picture, depth, past: false } : null;
  }
}
