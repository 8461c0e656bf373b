import { useMemo, useState } from "react";
import type { Pt } from "../../kernel/geometry/point.ts";
import { part } from "../../kernel/geometry/point.ts";
import { INCH, toDiameter } from "../../kernel/units.ts";
import { formatNumber } from "../../i18n/number.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import type { ContourChoice, DrawingGiven } from "../../program/drawing/drawing.ts";
import type { OpenedDrawing } from "../../app/document/drawing-request.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import type { Bounds, Camera } from "../../view/camera.ts";
import { ContourResult, rowText } from "./ContourResult.tsx";
import { DrawingChoices } from "./DrawingChoices.tsx";
import { DrawingSheet } from "./DrawingSheet.tsx";
import { boundsOfSegments, extent, widened } from "./extent.ts";
import { LeftOut, NoteList, type ListedNote } from "./NoteList.tsx";
import { placingOf } from "../../program/drawing/halves.ts";
import { segmentsOnDrawing } from "../../program/drawing/on-drawing.ts";
import type { ArrowKey, PickKind } from "../../program/drawing/pick.ts";
import { askDrawing } from "./read-drawing-file.ts";
import type { MadeContour } from "./use-opened-drawing.ts";

interface Props {
  readonly opened: OpenedDrawing;
  /** The newest contour, perhaps of the previous choice. */
  readonly made: MadeContour;
  readonly notes: readonly ListedNote[];
  readonly onGiven: (given: DrawingGiven) => void;
  readonly onChange: (change: Partial<ContourChoice>) => void;
}

const PICKS: readonly PickKind[] = ["contour", "axis", "zero"];
/** Room round the part, and round the place of a note, as shares of the part and of the drawing. */
const PART_ROOM = 0.4,
  NOTE_ROOM = 0.05;

/** Index of the row whose element is under a point of the part; null if none is within reach. */
function rowUnder(reading: ReturnType<typeof readRows>, p: Pt, within: number): number | null {
  let found: number | null = null,
    least = within;
  reading.contour.segments.forEach((s, i) => {
    const far = part.distanceTo(s, p);
    if (far <= least) [found, least] = [reading.rowOfSegment[i] ?? null, far];
  });
  return found;
}

/** The drawing with its picked contour, next to the choices by name, the notes and the contour as a table. */
export function DrawingPicker({ opened, made, notes, onGiven, onChange }: Props) {
  const { drawing, choice, proposed } = opened,
    { contour } = made;
  const t = useTexts("drawing-import"),
    language = useSettings((s) => s.language);
  const [pick, setPick] = useState<PickKind>("contour");
  const [activeRow, showRow] = useState<number | null>(null);
  const [activeNote, showNote] = useState<number | null>(null);
  const [said, setSaid] = useState({ text: "", times: 0 });
  const say = (text: string) => setSaid((old) => ({ text, times: old.times + 1 }));
  const reading = useMemo(() => readRows(contour.rows), [contour]);
  const { segments, rowOfSegment } = useMemo(() => {
    const each = segmentsOnDrawing(made.choice, reading.contour.segments);
    return {
      segments: each.flat(),
      rowOfSegment: each.flatMap((some, i) => some.map(() => reading.rowOfSegment[i] ?? 0)),
    };
  }, [made, reading]);
  const whole = useMemo(() => boundsOfSegments(drawing.curves.map((c) => c.segment)), [drawing]);
  // The overhang of a centre line is no size.
  const drawn = useMemo(
    () => extent(boundsOfSegments(drawing.curves.filter((c) => c.role !== "centre").map((c) => c.segment))),
    [drawing],
  );
  const show = (n: number, decimals = 3) => formatNumber(language, n, decimals);
  const per = drawing.unit.unit === "inch" ? INCH : 1;
  const own = useMemo(() => boundsOfSegments(reading.contour.segments), [reading]);
  const change = (next: Partial<ContourChoice>) => {
    showRow(null);
    onChange(next);
  };
  const tap = async (at: Pt, within: number) => {
    const result = await askDrawing(opened, { ask: "tap", of: pick, choice, at, within });
    if ("refused" in result) return say(t.refused[result.refused]);
    change(result.change);
    say(`${t.chosen}: ${t.pick[pick]}`);
  };
  const repropose = (given: Partial<ContourChoice>) => void askDrawing(opened, { ask: "proposal", given }).then(change);
  const pressKey = async (key: ArrowKey) => {
    const next = await askDrawing(opened, { ask: "key", of: pick, choice, key });
    if (next !== "nothing") change(next);
  };
  const partBox = () => widened(boundsOfSegments(segments), PART_ROOM);
  // At first the part, where the sheet round it is much larger.
  const [view, look] = useState<Camera | Bounds>(() => {
    const part = partBox();
    return segments.length > 0 &&
      Math.max(extent(part).wide / extent(whole).wide, extent(part).tall / extent(whole).tall) < 1
      ? part
      : whole;
  });
  const zoomTo = (at: Pt) =>
    look(
      widened(
        { left: at.z, right: at.z, low: at.r, high: at.r },
        Math.max(extent(whole).wide, extent(whole).tall) * NOTE_ROOM,
      ),
    );
  const activeEnd = activeRow === null ? null : (reading.rows[activeRow]?.end ?? null),
    activeElement = activeRow === null ? undefined : contour.rows[activeRow];
  const isProposed = (Object.keys(choice) as (keyof ContourChoice)[]).every((key) => choice[key] === proposed[key]);
  const noteProps = {
    notes,
    active: activeNote,
    onActive: showNote,
    onGap: (gap: number) => {
      // With more of the part, its end may be elsewhere: Z0 is proposed again unless it was chosen.
      const { zero, mirrored, ...others } = choice,
        isOwn = zero !== proposed.zero || mirrored !== proposed.mirrored;
      repropose({ ...others, gap, piece: 0, ...(isOwn && { zero, mirrored }) });
    },
    onShow: ({ note, number }: ListedNote) => {
      showNote(number);
      if (note.at) zoomTo(note.at);
    },
  };
  return (
    <div className="drawing-picker">
      <div className="drawing-stage">
        <DrawingSheet
          lead={
            <>
              <div className="view-switch drawing-pick" role="radiogroup" aria-label={t.pick.label}>
                {PICKS.map((each) => (
                  <label key={each} className="button">
                    <input type="radio" name="drawing-pick" checked={pick === each} onChange={() => setPick(each)} />
                    {t.pick[each]}
                  </label>
                ))}
              </div>
              <p className="small soft drawing-how">{t.pick.how[pick]}</p>
            </>
          }
          drawing={drawing}
          contour={contour}
          pick={pick}
          view={view}
          whole={whole}
          part={segments.length > 0 ? partBox : null}
          onView={look}
          onTap={(at, within) => void tap(at, within)}
          onArrow={(key) => void pressKey(key)}
          onChange={change}
          onHover={(at, within) =>
            showRow(at && pick === "contour" ? rowUnder(reading, placingOf(made.choice)(at), within) : null)
          }
          choice={choice}
          segments={segments}
          rowOfSegment={rowOfSegment}
          activeRow={activeRow}
          activeText={activeElement ? rowText(activeElement, activeEnd, language) : null}
          notes={notes.flatMap(({ note, number }) =>
            number !== null && note.at ? [{ number, at: note.at, severity: note.severity }] : [],
          )}
          activeNote={activeNote}
          words={{ axis: t.axis, picture: t.picture(contour.rows.length) }}
        />
        <p className="drawing-facts small">
          <span>
            {t.size(show(drawn.wide / per), show(drawn.tall / per), drawing.unit.unit === "inch" ? "inch" : "mm")}
          </span>
          {segments.length > 0 && (
            <b className="number">{t.partSize(show(toDiameter(own.high as Pt["r"])), show(own.right - own.left))}</b>
          )}
        </p>
        <p role="status" className={said.text === "" ? "unseen" : "drawing-said small"}>
          <span key={said.times}>{said.text}</span>
        </p>
      </div>
      <div className="drawing-panel">
        <NoteList {...noteProps} />
        <DrawingChoices
          drawing={drawing}
          choice={choice}
          proposed={proposed}
          contour={contour}
          onGiven={onGiven}
          onAxis={(axis) => {
            const { gap, reversed, thin, diameters, withoutLayers } = choice;
            repropose({ axis, gap, reversed, thin, diameters, withoutLayers });
          }}
          onChange={change}
        />
        {!isProposed && (
          <button type="button" className="button" onClick={() => change(proposed)}>
            {t.useProposal}
          </button>
        )}
        {contour.rows.length < 2 ? (
          <p>{t.noContour}</p>
        ) : (
          <ContourResult rows={contour.rows} reading={reading} active={activeRow} onActive={showRow} />
        )}
        <LeftOut {...noteProps} />
      </div>
    </div>
  );
}
