import type { Spindle } from "../../kernel/time/step.ts";
import { speedAt, withinLimit, type RapidRate } from "../../kernel/time/time.ts";
import type { MachineData, MachineTimed, OfAxes, SpindleTurns } from "../machine/machine-data.ts";
import type { Modal } from "./modal.ts";

/** Rapid rates for times: those of the machine's axes, else one rate along the path. */
function rapidRateOf({ rapid, machine }: MachineTimed): RapidRate {
  const { rapid: rates, acceleration } = machine ?? {};
  if (!rates) return rapid;
  const axis = (name: keyof OfAxes) => ({
    rate: rates[name],
    ...(acceleration && { acceleration: acceleration[name] }),
  });
  return { x: axis("x"), z: axis("z") };
}

/** Times and speeds of a machine for programmed values. */
export class MachineClock {
  /** Rapid rates for times. */
  readonly rapid: RapidRate;
  private readonly data: MachineData["spindle"];
  /** Limited spindles by programmed spindle, so that the same one stays identical. */
  private readonly known = new WeakMap<Spindle, Spindle>();

  constructor(timed: MachineTimed) {
    this.rapid = rapidRateOf(timed);
    this.data = timed.machine?.spindle;
  }

  /** A programmed spindle, limited to the machine's maximum speed. */
  limited(spindle: Spindle | null): Spindle | null {
    if (!spindle || !this.data) return spindle;
    const made = this.known.get(spindle) ?? withinLimit(spindle, this.data.most);
    this.known.set(spindle, made);
    return made;
  }

  /**
   * Seconds until the spindle reaches the programmed state at a distance of `r` mm from the axis: from rest, another
   * speed, or reverse. Along a cut at constant surface speed it follows without delay. Null where nothing changes.
   */
  runUp(
    { turns, backwards, lastTurns, spindle: programmed }: Modal,
    r: number,
  ): { readonly seconds: number; readonly runsAs: SpindleTurns } | null {
    const spindle = this.limited(programmed);
    if (!turns || !spindle || !this.data || (lastTurns?.spindle === spindle && lastTurns.backwards === backwards))
      return null;
    const [was, is] = [lastTurns ? speedAt(lastTurns.spindle, r) : 0, speedAt(spindle, r)];
    const by = lastTurns && lastTurns.backwards !== backwards ? was + is : Math.abs(is - was);
    return { seconds: ((this.data.runUp ?? 0) * by) / this.data.most, runsAs: { spindle, backwards } };
  }
}
