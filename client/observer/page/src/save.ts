// Bug reports: one frame, or the seconds around it, as a file.
import { saveBundle } from "./api";
import { el } from "./dom";
import { observerNow } from "./pace";
import { nearestInstead, type Reel } from "./reel";

const LATE_MS = 1500; // frames of now are on disk by then

export class Save {
  readonly element: HTMLElement;
  readonly frame = el("button", { type: "button", title: "key f" }, "save frame");
  readonly seconds = el("button", { type: "button", title: "key w" }, "save");
  private readonly around = el("input", { type: "number", id: "around", min: "1", max: "600", value: "5", required: "", "aria-label": "seconds before and after" });
  private readonly told = el("span", { role: "status", class: "soft", id: "saved" });

  constructor(
    private readonly robot: string,
    private readonly reel: Reel,
  ) {
    this.element = el("span", { class: "bar" }, this.frame, this.seconds, el("label", {}, "± ", this.around, " s"), this.told);
    this.frame.addEventListener("click", () => void this.save(0));
    this.seconds.addEventListener("click", () => {
      if (this.around.checkValidity()) void this.save(Number(this.around.value));
      else this.say("seconds before and after: a whole number from 1 to 600", true);
    });
  }

  private async save(around: number): Promise<void> {
    const shown = this.reel.current;
    if (!shown) return;
    const at = shown.line.came_at_us;
    try {
      const wait = around * 1000 + LATE_MS - (observerNow() - at / 1000);
      if (wait > 0) {
        this.say(`saving in ${Math.ceil(wait / 1000)} s, when what follows is there`);
        await new Promise((done) => setTimeout(done, wait));
      }
      this.say("saving");
      const { name, answeredAtMs } = await saveBundle(this.robot, at, around, around);
      const instead = nearestInstead(shown, answeredAtMs);
      this.say(`saved ${name}${instead && `: ${instead}`}`, instead !== "");
    } catch (error) {
      this.say((error as Error).message, true);
    }
  }

  private say(text: string, isBad = false): void {
    this.told.textContent = text;
    this.told.classList.toggle("bad", isBad);
  }
}
