import type { ReactNode, RefObject } from "react";
import { Toolbar } from "react-aria-components/Toolbar";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import type { CornerKind } from "./drawing-edits.ts";
import type { RowActions } from "./use-table-keys.ts";

/** Icons of the row commands, 24 units square. */
const paths = {
  add: "M12 5v14M5 12h14",
  insert: "M4 18h16M12 3v10M7 8h10",
  duplicate: "M8 8h12v12H8zM16 8V4H4v12h4",
  remove: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13M10 11v6M14 11v6",
  up: "M12 19V5M6 11l6-6 6 6",
  down: "M12 5v14M6 13l6 6 6-6",
  round: "M5 20V13a8 8 0 0 1 8-8h7",
  chamfer: "M5 20V12l7-7h8",
  undercut: "M3 10h6l3 4h5V4h4M17 14v6H3",
} as const;

interface Props {
  readonly bar: RefObject<HTMLDivElement | null>;
  /** The focused element, from 1; null when there is none. */
  readonly number: number | null;
  readonly count: number;
  readonly actions: RowActions;
  readonly language: Language;
  /** The element whose end corner can be broken, from 1; null when there is none. */
  readonly corner: number | null;
  readonly onCorner: (kind: CornerKind) => void;
  readonly onUndercut: () => void;
  /** Whether the fields of angle and length are shown. */
  readonly details: boolean;
  readonly onDetails: () => void;
  /** More controls of the bar. */
  readonly children?: ReactNode;
}

/** The actions on the rows of the contour table; each button names the element it changes. */
export function RowTools({
  bar,
  number,
  count,
  actions,
  language,
  corner,
  onCorner,
  onUndercut,
  details,
  onDetails,
  children,
}: Props) {
  const t = texts(language).contour;
  const n = number ?? 1;
  const none = number === null;
  const tools = [
    { icon: "add", name: t.add, off: false, act: actions.add },
    {
      icon: "insert",
      name: t.insertBefore(n),
      off: none,
      act: actions.insert,
    },
    { icon: "duplicate", name: t.duplicate(n), off: none, act: actions.duplicate },
    {
      icon: "up",
      name: t.moveUp(n),
      off: none || n === 1,
      act: () => actions.move(-1),
    },
    { icon: "down", name: t.moveDown(n), off: none || n === count, act: () => actions.move(1) },
    {
      icon: "round",
      name: t.round(corner ?? n),
      off: corner === null,
      act: () => onCorner("RND"),
    },
    { icon: "chamfer", name: t.chamfer(corner ?? n), off: corner === null, act: () => onCorner("CHF") },
    { icon: "undercut", name: t.undercut(corner ?? n), off: corner === null, act: onUndercut },
    {
      icon: "remove",
      name: t.remove(n),
      off: none,
      act: actions.remove,
    },
  ] as const;
  return (
    <Toolbar ref={bar} aria-label={t.head.actions} className="contour-tools">
      {tools.map(({ icon, name, off, act }) => (
        <button
          key={icon}
          type="button"
          className="button icon plain"
          aria-label={name}
          title={name}
          disabled={off}
          onClick={act}
        >
          <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
            <path d={paths[icon]} />
          </svg>
        </button>
      ))}
      <button type="button" className="button contour-details" aria-pressed={details} onClick={onDetails}>
        {t.details}
      </button>
      {children}
      {number !== null && (
        <span className="small soft contour-tools-row">
          <span className="number">{number}</span> / <span className="number">{count}</span>
        </span>
      )}
    </Toolbar>
  );
}
