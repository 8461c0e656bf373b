import type { Spindle } from "../../kernel/time/step.ts";
import { speedAt, withinLimit, type RapidRate } from "../../kernel/time/time.ts";
import type { MachineData, MachineTimed, OfAxes, SpindleTurns } from "../machine/machine-data.ts";
import type { Modal } from "./modal.ts";

/** What rapids are timed with: what the machine states of its axes, else one rate along the path. */
function rapidRateOf({ rapid, machine }: MachineTimed): RapidRate {
  const { rapid: rates, acceleration } = machine ?? {};
  if (!rates) return rapid;
  const axis = (name: keyof OfAxes) => ({
    rate: rates[name],
    ...(acceleration && { acceleration: acceleration[name] }),
  });
  return { x: axis("x"), z: axis("z") };
}

/** What a machine makes of what is programmed, in time. */
export class MachineClock {
  /** What rapids are timed with. */
  readonly rapid: RapidRate;
  private readonly data: MachineData["spindle"];
  /** What it makes of programmed spindles: the same one stays the same. */
  private readonly known = new WeakMap<Spindle, Spindle>();

  constructor(timed: MachineTimed) {
    this.rapid = rapidRateOf(timed);
    this.data = timed.machine?.spindle;
  }

  /** A spindle as it turns: as programmed, and no faster than the machine lets it. */
  limited(spindle: Spindle | null): Spindle | null {
    if (!spindle || !this.data) return spindle;
    const made = this.known.get(spindle) ?? withinLimit(spindle, this.data.most);
    this.known.set(spindle, made);
    return made;
  }

  /**
   * Seconds until the spindle turns as is programmed now, at a distance of `r` mm from the axis: from rest, from
   * another speed, or from turning the other way. Along a cut at constant cutting speed it follows by itself. Null
   * where it turns so already.
   */
  runUp(
    { turns, backwards, runsAs, spindle: programmed }: Modal,
    r: number,
  ): { readonly seconds: number; readonly runsAs: SpindleTurns } | null {
    const spindle = this.limited(programmed);
    if (!turns || !spindle || !this.data || (runsAs?.spindle === spindle && runsAs.backwards === backwards))
      return null;
    const [was, is] = [runsAs ? speedAt(runsAs.spindle, r) : 0, speedAt(spindle, r)];
    const by = runsAs && runsAs.backwards !== backwards ? was + is : Math.abs(is - was);
    return { seconds: ((this.data.runUp ?? 0) * by) / this.data.most, runsAs: { spindle, backwards } };
  }
}
