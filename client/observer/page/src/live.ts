// What comes of one robot, as fast as it can be fetched: the newest frame each time.
import { answerOf, depthOf, pictureOf, RETRY_MS } from "./api";
import type { RobotLine, Seen } from "./types";

export class Live {
  listed: RobotLine | null = null; // as the list of robots has it
  onLine: (line: RobotLine) => void = () => {};
  onFrame: (seen: Seen) => void = () => {};
  private newest: RobotLine | null = null;
  private fetched = 0; // its number
  private preview = 0; // the number of a frame that only the list has
  private wasUpdated = false;
  private busy = false;

  constructor(
    private readonly robot: string,
    private readonly withDepth: () => boolean,
  ) {}

  // What the list has counts at first, as the robot's next frame may be far away.
  update(close: RobotLine | undefined, listed: RobotLine | undefined): void {
    const isFirst = !this.wasUpdated;
    this.wasUpdated = true;
    this.listed = listed ?? this.listed;
    const isListed = isFirst && (listed?.id ?? 0) > (close?.id ?? 0);
    const line = isListed ? listed : close;
    if (!line || (this.newest && line.id <= this.newest.id)) return;
    if (isListed) this.preview = line.id;
    this.newest = line;
    this.onLine(line);
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
      line.has_picture ? pictureOf(line.id === this.preview ? "preview" : "picture", this.robot, line.id) : null,
      this.withDepth() ? depthOf(this.robot, line.id) : null,
    ]);
    return frame ? { line, frame, picture, depth, past: false } : null;
  }
}
