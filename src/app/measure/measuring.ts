import { useRef, useState } from "react";
import type { MeasuredKind } from "../../kernel/measured.ts";
import type { Place } from "../../view/camera.ts";
import type { Touches } from "../lathe/gestures.ts";

/** What pointers and keys do while something is measured. It comes with the tools of measuring, which are fetched when asked for. */
export interface MeasureHand extends Touches {
  /** True when the key was meant for measuring. */
  readonly key: (name: string) => boolean;
}

/** Whether a picture measures, and with which tool. Stands beside the picture of a turned part as of a milled plane. */
export interface Measuring extends MeasureHand {
  readonly on: boolean;
  readonly kind: MeasuredKind;
  readonly choose: (kind: MeasuredKind) => void;
  readonly toggle: () => void;
  /** Takes pointers and keys over, from the tools of measuring; null gives them back. */
  readonly serve: (hand: MeasureHand | null) => void;
}

/**
 * Measuring in a picture. The picture gives pointers and keys to this while it is on (`useStage`, `pressKey`), and shows
 * `Measurements` inside of its stage, with a `MeasureSource` that says what there is to measure.
 */
export function useMeasuring(): Measuring {
  const [on, set] = useState(false), [kind, choose] = useState<MeasuredKind>("distance");
  const hand = useRef<MeasureHand | null>(null);
  /** A place that was tapped while the tools were on their way. */
  const early = useRef<Place | null>(null);
  return {
    on,
    kind,
    choose,
    toggle: () => set(!on),
    serve(next) {
      hand.current = next;
      const at = early.current;
      if (!next || !at) return;
      early.current = null;
      next.tap(at);
    },
    tap(at) {
      if (hand.current) hand.current.tap(at);
      else early.current = at;
    },
    hover: (at) => hand.current?.hover(at),
    drag: (from, to, done, byFinger) => hand.current?.drag?.(from, to, done, byFinger),
    key(name) {
      if (!on) return false;
      if (hand.current?.key(name)) return true;
      if (name === "Escape") set(false);
      return name === "Escape";
    },
  };
}
