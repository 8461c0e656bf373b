import { useMemo, useState } from "react";
import { createStore, useStore, type StoreApi } from "zustand";
import type { MeasuredKind, MeasuredPlace } from "../../../kernel/plan/measured.ts";
import type { LabelBox } from "../../../view/help/labels.ts";
import type { Touches } from "../lathe/gestures.ts";

/** Where measuring is. */
export interface MeasureState {
  readonly on: boolean;
  readonly kind: MeasuredKind;
  /** What the cross has hold of. */
  readonly cross: MeasuredPlace | null;
  readonly first: MeasuredPlace | null;
  /** What was measured last with this tool. */
  readonly done: { readonly kind: MeasuredKind; readonly places: readonly MeasuredPlace[] } | null;
  /** Why nothing was measured; empty where nothing is to be said. */
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
/** What else measures: the next edge, the one before, a pick, and the ways of the cross. */
const OTHER_KEYS: readonly string[] = ["n", "p", "enter", "arrowleft", "arrowright", "arrowup", "arrowdown"];
const KEYS: ReadonlySet<string> = new Set([...Object.values(TOOL_KEYS), ...OTHER_KEYS]);

/**
 * What pointers and keys do while something is measured. It comes with the tools of measuring, which are fetched when
 * asked for.
 */
export interface MeasureHand extends Touches {
  readonly drag: NonNullable<Touches["drag"]>;
  /** True when the key was meant for measuring. */
  readonly key: (name: string) => boolean;
}

/** Measuring in one picture, of a turned part as of a milled plane. */
export interface Measuring extends MeasureHand {
  /**
   * The one place that says where measuring is. Whatever is pressed reads it and writes it at once, and never what was
   * drawn last: two presses may come before the first of them is drawn.
   */
  readonly state: StoreApi<MeasureState>;
  /** The room that measured numbers take in the picture: what moves about there keeps off it. */
  readonly labels: StoreApi<readonly LabelBox[]>;
  readonly choose: (kind: MeasuredKind) => void;
  readonly toggle: () => void;
  /** Takes pointers and keys over, from the tools of measuring. Gives the way to give them back. */
  readonly serve: (hand: MeasureHand) => () => void;
}

/** The same, as it is drawn. */
export interface MeasuringShown extends Measuring {
  readonly on: boolean;
}

const NOTHING_HELD: Omit<MeasureState, "on" | "kind"> = { cross: null, first: null, done: null, said: "" };

/** Measuring in one picture, switched off. */
export function createMeasuring(): Measuring {
  const state = createStore<MeasureState>(() => ({ on: false, kind: "distance", ...NOTHING_HELD }));
  let served: MeasureHand | null = null;
  /** What was pressed and tapped while the tools were on their way: they do it when they are there. */
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
 * Measuring in a picture. The picture gives pointers and keys to this while it is on (`useStage`, `pressKey`), and
 * shows `Measurements` inside of its stage, with a `MeasureSource` that says what there is to measure.
 */
export function useMeasuring(): MeasuringShown {
  const [measuring] = useState(createMeasuring),
    on = useStore(measuring.state, (s) => s.on);
  return useMemo(() => ({ ...measuring, on }), [measuring, on]);
}
