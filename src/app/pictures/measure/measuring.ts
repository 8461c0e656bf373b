import { useMemo, useState } from "react";
import { createStore, useStore, type StoreApi } from "zustand";
import type { MeasuredKind, MeasuredPlace } from "../../../kernel/plan/measured.ts";
import type { LabelBox } from "../../../view/dimensions/labels.ts";
import type { PointerActions } from "../lathe/gestures.ts";

/** State of measuring. */
export interface MeasureState {
  readonly on: boolean;
  readonly kind: MeasuredKind;
  /** Place that the cross is snapped to. */
  readonly cross: MeasuredPlace | null;
  readonly first: MeasuredPlace | null;
  /** The last measurement of this tool. */
  readonly done: { readonly kind: MeasuredKind; readonly places: readonly MeasuredPlace[] } | null;
  /** Why nothing was measured; empty without a message. */
  readonly said: string;
}

/** The key of each tool. */
export const TOOL_KEYS: Readonly<Record<MeasuredKind, string>> = {
  diameter: "d",
  length: "l",
  depth: "s",
  distance: "t",
  radius: "r",
  angle: "a",
  wall: "w",
};
/** Other keys: next and previous edge, pick, and moving the cross. */
const OTHER_KEYS: readonly string[] = ["n", "p", "enter", "arrowleft", "arrowright", "arrowup", "arrowdown"];
const KEYS: ReadonlySet<string> = new Set([...Object.values(TOOL_KEYS), ...OTHER_KEYS]);

/** Pointer and key handlers while measuring. They come with the measuring tools, which are loaded on demand. */
export interface MeasureHand extends PointerActions {
  readonly drag: NonNullable<PointerActions["drag"]>;
  /** True if the key was for measuring. */
  readonly key: (name: string) => boolean;
}

/** Measuring in one picture, of a turned part or a milled plane. */
export interface Measuring extends MeasureHand {
  /**
   * The single state of measuring. Inputs read and write it at once, never the last rendered state, since two inputs
   * may come before the first is rendered.
   */
  readonly state: StoreApi<MeasureState>;
  /** The areas of the measured numbers; moving elements avoid them. */
  readonly labels: StoreApi<readonly LabelBox[]>;
  readonly choose: (kind: MeasuredKind) => void;
  readonly toggle: () => void;
  /** Registers the handlers of the measuring tools. Returns the function that removes them. */
  readonly serve: (hand: MeasureHand) => () => void;
}

/** The same, as rendered. */
export interface MeasuringShown extends Measuring {
  readonly on: boolean;
}

const NOTHING_HELD: Omit<MeasureState, "on" | "kind"> = { cross: null, first: null, done: null, said: "" };

/** Measuring in one picture, switched off. */
export function createMeasuring(): Measuring {
  const state = createStore<MeasureState>(() => ({ on: false, kind: "distance", ...NOTHING_HELD }));
  let served: MeasureHand | null = null;
  /** Inputs that came before the tools were loaded; they run once the tools are there. */
  let early: readonly ((hand: MeasureHand) => void)[] = [];
  const byHand = (act: (hand: MeasureHand) => void) => {
    if (served) act(served);
    else early = [...early, act];
  };
  const toggle = () => {
    early = [];
    state.setState(({ on }) => ({ on: !on, ...NOTHING_HELD }));
  };
  return {
    state,
    labels: createStore<readonly LabelBox[]>(() => []),
    toggle,
    choose(kind) {
      if (kind !== state.getState().kind) state.setState({ kind, first: null, done: null, said: "" });
    },
    serve(hand) {
      served = hand;
      const due = early;
      early = [];
      for (const act of due) act(hand);
      return () => {
        if (served === hand) served = null;
      };
    },
    tap: (at) => byHand((hand) => hand.tap(at)),
    hover: (at) => served?.hover(at),
    drag(from, to, done, byFinger) {
      if (done) byHand((hand) => hand.drag(from, to, done, byFinger));
      else served?.drag(from, to, done, byFinger);
    },
    key(name) {
      if (!state.getState().on) return false;
      if (served?.key(name)) return true;
      if (name === "Escape") toggle();
      else if (!served && KEYS.has(name.toLowerCase())) byHand((hand) => void hand.key(name));
      else return false;
      return true;
    },
  };
}

/**
 * Measuring in a picture. The picture passes pointers and keys on while this is on (`useStage`, `pressKey`), and
 * renders `Measurements` in its stage with a `MeasureSource` of its content.
 */
export function useMeasuring(): MeasuringShown {
  const [measuring] = useState(createMeasuring),
    on = useStore(measuring.state, (s) => s.on);
  return useMemo(() => ({ ...measuring, on }), [measuring, on]);
}
