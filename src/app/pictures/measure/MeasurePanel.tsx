import { useContext, useEffect, useRef, useState } from "react";
import { Toolbar } from "react-aria-components/Toolbar";
import type { MeasuredKind } from "../../../kernel/plan/measured.ts";
import { toDiameter } from "../../../kernel/units.ts";
import type { MeasureTexts } from "../../../i18n/en/measure.ts";
import type { Lengths } from "../../../i18n/lengths.ts";
import { formatNumber } from "../../../i18n/number.ts";
import type { LabelBox } from "../../../view/dimensions/labels.ts";
import { inBlockUnits, fieldValueOf, measure, rulerValueFor } from "../../../view/measure/distance.ts";
import type { CurrentMeasurement } from "../../../view/measure/reading.ts";
import { setMeasured } from "../../document/edits.ts";
import { Icon } from "../../base/Icon.tsx";
import { useLengths } from "../../calculation/lengths.ts";
import { MeasuredTargetContext, type MeasuredTarget } from "../../document/measured-target-context.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { pageUnit } from "../../base/unit.ts";
import { useMedia } from "../../base/use-media.ts";
import { otherText, gaugedText, type MeasurementWords } from "./measure-words.ts";
import { removeMeasurement } from "./MeasuredLabels.tsx";
import { toolsOf } from "./hand.ts";
import { TOOL_KEYS, type Measuring, type MeasureState } from "./measuring.ts";
import type { MeasureSource } from "./source.ts";

/** Line drawings of the tools, 24 units square. */
const TOOLS: Readonly<Record<MeasuredKind, string>> = {
  diameter: "M12 4a8 8 0 1 0 0 16a8 8 0 1 0 0-16zM5 19L19 5",
  length: "M4 6v12M20 6v12M4 12h16M7.5 9.5L4 12l3.5 2.5M16.5 9.5L20 12l-3.5 2.5",
  depth: "M4 20h7V9h9M16 9v11M13.5 12.5L16 9l2.5 3.5M13.5 16.5L16 20l2.5-3.5",
  distance: "M5 19L19 5M5 19v-4.5M5 19h4.5M19 5v4.5M19 5h-4.5",
  radius: "M5 19V14a9 9 0 0 1 9-9h5M19 19L8 8M8 12V8h4",
  angle: "M4 19h16M4 19L16 5M13 19a9 9 0 0 0-3.2-6.9",
  wall: "M4 5h16M4 19h16M12 5v14M9.5 8.5L12 5l2.5 3.5M9.5 15.5L12 19l2.5-3.5",
};

/** While a tool is active the keys go to the picture. */
const toPicture = (element: HTMLElement): void =>
  element.closest<HTMLElement>(".lathe-stage")?.focus({ preventScroll: true });

interface Tools {
  readonly kind: MeasuredKind;
  readonly choose: (kind: MeasuredKind) => void;
  readonly source: MeasureSource;
  readonly t: MeasureTexts;
}

/** The tools as a select box, where a row has no room. */
function ToolChoice({ kind, choose, source, t }: Tools) {
  return (
    <select
      className="select"
      aria-label={t.tools}
      value={kind}
      onChange={(event) => {
        const chosen = toolsOf(source).find((each) => each === event.currentTarget.value);
        if (chosen) choose(chosen);
      }}
    >
      {toolsOf(source).map((each) => (
        <option key={each} value={each}>
          {t.kinds[each]}
        </option>
      ))}
    </select>
  );
}

function ToolBar({ kind, choose, source, t }: Tools) {
  return (
    <Toolbar className="measure-tools" aria-label={t.tools}>
      {toolsOf(source).map((each) => (
        <button
          key={each}
          type="button"
          className="button icon"
          aria-label={t.kinds[each]}
          title={t.toolHints[each]}
          aria-keyshortcuts={TOOL_KEYS[each]}
          aria-pressed={kind === each}
          onClick={(event) => {
            choose(each);
            toPicture(event.currentTarget);
          }}
        >
          <svg className="icon" viewBox="0 0 24 24" aria-hidden="true">
            <path d={TOOLS[each]} />
          </svg>
        </button>
      ))}
    </Toolbar>
  );
}

/** What a tool needs next, or why it measured nothing. */
function hintOf(t: MeasureTexts, kind: MeasuredKind, { first, said }: MeasureState, isTurned: boolean): string {
  if (said) return said;
  if (first) return kind === "angle" ? t.pickSecondEdge : t.pickSecond;
  return kind === "diameter" && !isTurned ? t.pickCircle : t.pick[kind];
}

/** A measured value for the open prompt, in the unit and datum of its block; null if it is of another kind. */
function offered(target: MeasuredTarget | null, state: MeasureState, value: number | undefined): number | null {
  const found = offeredPlain(target, state, value);
  return target && found !== null ? inBlockUnits(target.kind, found, target.counts) : null;
}

/** The same in mm, from the workpiece zero. */
function offeredPlain(
  target: MeasuredTarget | null,
  { first, done }: MeasureState,
  value: number | undefined,
): number | null {
  if (!target) return null;
  if (done && value !== undefined) {
    const sized = fieldValueOf(target.kind, done.kind, value);
    if (sized !== null && done.kind !== "distance") return sized;
  }
  const [from, to] = done ? done.places : [first ?? undefined];
  if (!from || (done && done.kind !== "distance")) return null;
  return rulerValueFor(target.kind, (to ?? from).at, to ? measure(from.at, to.at) : null);
}

/** Position of the cross, or its distance from the first place. */
function Numbers({
  state: { cross, first, done },
  value,
  isTurned,
  lengths,
  t,
}: {
  readonly state: MeasureState;
  readonly value: number | undefined;
  readonly isTurned: boolean;
  readonly lengths: Lengths;
  readonly t: MeasureTexts;
}) {
  const lathe = useTexts().lathe,
    n = lengths.position;
  const [a, b] = done?.kind === "distance" ? done.places : [first, cross];
  if (done && value !== undefined && done.kind !== "distance") {
    const other = otherText(t, lengths, done.kind, value);
    return (
      <p className="measure-value number">
        <b>{gaugedText(lengths, done.kind, value)}</b>
        {other && <span className="soft">{other}</span>}
      </p>
    );
  }
  if (!cross && !a) return null;
  const rows: readonly (readonly [string, string])[] = [];
  const way = a && b ? measure(a.at, b.at) : null,
    at_ = cross?.at ?? a?.at;
  const shown = way
    ? [
        ...rows,
        isTurned ? [lathe.deltaX, n(way.dx)] : ["ΔX", n(way.dz)],
        isTurned ? [lathe.deltaZ, n(way.dz)] : ["ΔY", n(b && a ? b.at.r - a.at.r : 0)],
        [lathe.distance, gaugedText(lengths, "distance", way.distance)],
        ...(value ? [["", otherText(t, lengths, "distance", value)]] : []),
      ]
    : at_
      ? [
          isTurned ? [lathe.axisX, n(toDiameter(at_.r))] : ["X", n(at_.z)],
          isTurned ? [lathe.axisZ, n(at_.z)] : ["Y", n(at_.r)],
        ]
      : [];
  return (
    <dl className="number">
      {shown.map(([label = "", text = ""]) => (
        <div key={label}>
          <dt>{label}</dt>
          <dd>{text}</dd>
        </div>
      ))}
    </dl>
  );
}

/** The list of measurements, which can be removed one by one or all at once. */
function MeasuredList({
  readings,
  words,
  t,
  say,
}: {
  readonly readings: readonly CurrentMeasurement[];
  readonly words: ReadonlyMap<string, MeasurementWords>;
  readonly t: MeasureTexts;
  readonly say: (text: string) => void;
}) {
  const summary = useRef<HTMLElement>(null);
  if (readings.length === 0) return null;
  const gone = (text: string) => {
    say(text);
    summary.current?.focus();
  };
  return (
    <details className="measure-list">
      <summary ref={summary}>{t.count(String(readings.length))}</summary>
      <ul aria-label={t.measured}>
        {readings.map(({ measurement: { id }, isStale }) => {
          const name = words.get(id)?.name ?? "";
          return (
            <li key={id} className={isStale ? "old" : undefined}>
              <span className="number">{name}</span>
              <button
                type="button"
                className="button icon"
                aria-label={t.remove(name)}
                title={t.remove(name)}
                onClick={() => {
                  removeMeasurement(id);
                  gone(t.removed(name));
                }}
              >
                <Icon name="close" />
              </button>
            </li>
          );
        })}
      </ul>
      <button
        type="button"
        className="button small"
        onClick={() => {
          const ids = new Set(readings.map(({ measurement: { id } }) => id));
          setMeasured((list) => list.filter(({ id }) => !ids.has(id)));
          say(t.cleared);
        }}
      >
        {t.clear}
      </button>
    </details>
  );
}

/**
 * The measuring tools over the picture, their reading, and the list of measurements. `kept` is called with the area it
 * takes.
 */
export function MeasurePanel({
  measuring,
  source,
  state,
  readings,
  words,
  kept,
}: {
  readonly measuring: Measuring;
  readonly source: MeasureSource;
  readonly state: MeasureState;
  readonly readings: readonly CurrentMeasurement[];
  readonly words: ReadonlyMap<string, MeasurementWords>;
  readonly kept: (box: LabelBox | null) => void;
}) {
  const t = useTexts("measure"),
    take = useTexts().lathe.takeInto,
    lengths = useLengths();
  const target = useContext(MeasuredTargetContext),
    panel = useRef<HTMLDivElement>(null),
    isTurned = source.plane === "ZX";
  const [spoken, speak] = useState({ text: "", after: state }),
    isPhone = useMedia("phone");
  useEffect(() => {
    const element = panel.current;
    if (!element || typeof ResizeObserver === "undefined") return;
    const watch = new ResizeObserver(() => {
      // An open list covers the picture for a moment; nothing moves out of its way.
      if (element.querySelector("details[open]")) return;
      const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = element,
        unit = pageUnit();
      kept({ x: offsetLeft / unit, y: offsetTop / unit, width: offsetWidth / unit, height: offsetHeight / unit });
    });
    watch.observe(element);
    return () => watch.disconnect();
  }, [kept]);
  const { kind } = state;
  // The last measurement with its present value; not shown once removed.
  const own = readings.find(({ measurement }) => measurement.places === state.done?.places),
    done = own ? state.done : null;
  const into = offered(target, { ...state, done }, own?.value);
  const result = own ? (words.get(own.measurement.id)?.name ?? "") : "";
  // A message about the list stays until the next pick.
  const said = spoken.after === state ? spoken.text : "";
  const tools: Tools = { kind, choose: measuring.choose, source, t };
  return (
    <div ref={panel} className="measure-panel">
      {isPhone ? <ToolChoice {...tools} /> : <ToolBar {...tools} />}
      <button
        type="button"
        className="button icon measure-stop"
        aria-label={t.stop}
        title={t.stop}
        onClick={(event) => {
          toPicture(event.currentTarget);
          measuring.toggle();
        }}
      >
        <Icon name="close" />
      </button>
      <Numbers state={{ ...state, done }} value={own?.value} isTurned={isTurned} lengths={lengths} t={t} />
      {target && into !== null && (
        <button type="button" className="button small" onClick={() => target.take(into)}>
          {take(
            `${target.kind === "diameter" ? "⌀" : ""}${formatNumber(lengths.language, into, target.counts.unit === 1 ? 3 : 4)}`,
            target.q,
          )}
        </button>
      )}
      {!done && <p className="measure-hint small soft">{hintOf(t, kind, state, isTurned)}</p>}
      <p role="status" className="unseen">
        {said || (done ? result : `${hintOf(t, kind, state, isTurned)} ${t.keys}`)}
      </p>
      <MeasuredList readings={readings} words={words} t={t} say={(text) => speak({ text, after: state })} />
    </div>
  );
}
