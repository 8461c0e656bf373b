import { useId, useMemo, useState } from "react";
import { formatNumber } from "../../i18n/number.ts";
import type { ExportTexts } from "../../i18n/en/export.ts";
import { DXF_CHORD, writeDxf } from "../../program/drawing/write-dxf.ts";
import { contourSvg } from "../../view/contour-svg.ts";
import { bodyStl } from "../../view/solid/export.ts";
import { showsPlane, useAskedView } from "../../app/pictures/plane/shown-view.ts";
import { downloadBytes, downloadText } from "../../app/base/download.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import { playback } from "../../app/calculation/playback.ts";
import { useOutcome, type Outcome } from "../../app/calculation/outcome.ts";
import { useLengths } from "../../app/calculation/lengths.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import {
  BODIES,
  bodiesOf,
  contoursOf,
  drawnTogether,
  layersOf,
  turnedMoment,
  type BodyName,
  type OfferedBody,
  type OfferedContour,
} from "./exports.ts";
import "./export.css";

/** Exports bodies and contour of the open work, as they are when the dialog opens. `stem`: prefix of the file names. */
export function PartExport({ stem, done }: { readonly stem: string; readonly done: () => void }) {
  const words = useTextsOrNull("export");
  return words && <Opened words={words} stem={stem} done={done} />;
}

function Opened({
  words: t,
  stem,
  done,
}: {
  readonly words: ExportTexts;
  readonly stem: string;
  readonly done: () => void;
}) {
  const lengths = useLengths();
  const shown = useOutcome((s) => s.shown),
    dimmed = useOutcome((s) => s.dimmed);
  const [said, say] = useState("");
  return (
    <ModalDialog className="modal export-part" title={t.title} done={done}>
      <p>{lengths.unit === "mm" ? t.lead : t.leadInches}</p>
      {dimmed && <Message tone="warning">{t.older}</Message>}
      {!shown || shown.isBeginning ? (
        <p role="status">{t.beginning}</p>
      ) : (
        <>
          <Bodies words={t} outcome={shown} stem={stem} say={say} />
          <Contours words={t} outcome={shown} stem={stem} say={say} />
        </>
      )}
      <p role="status" className="export-said">
        {said}
      </p>
    </ModalDialog>
  );
}

interface Part {
  readonly words: ExportTexts;
  readonly outcome: Outcome;
  readonly stem: string;
  readonly say: (text: string) => void;
}

function Bodies({ words: t, outcome: { run, simulation }, stem, say }: Part) {
  const lengths = useLengths(run),
    { language } = lengths;
  const asked = useAskedView((v) => v.asked),
    { position: shown } = playback.get();
  const position = useMemo(() => turnedMoment(run, shown, showsPlane(run, asked)), [run, shown, asked]);
  const bodies = useMemo(() => bodiesOf(run, simulation, position), [run, simulation, position]);
  const count = (n: number) => formatNumber(language, n, 0);
  const hint = (name: BodyName, body: OfferedBody) => {
    if (name === "stock") return t.bodyHint.stock(count(position.step), count(run.steps.length));
    return "isLeft" in body ? t.bodyHint.left : t.bodyHint[name];
  };
  const save = (name: BodyName, body: OfferedBody) => {
    if ("lack" in body) return;
    const { bytes, volume, hasRings } = bodyStl(body, `${stem} ${name}`);
    const file = downloadBytes(bytes, `${stem}_${t.file[name]}.stl`);
    const saved = t.saved(file, lengths.volume(volume));
    say(hasRings ? `${saved} ${t.rings}` : saved);
  };
  return (
    <section aria-label={t.bodies}>
      <h3>{t.bodies}</h3>
      <ul className="export-bodies">
        {BODIES.map((name) => {
          const body = bodies[name],
            lacks = "lack" in body;
          return (
            <li key={name}>
              <div>
                <b>{t.body[name]}</b>
                <p className="small soft">{lacks ? t.lack[body.lack] : hint(name, body)}</p>
              </div>
              <button
                type="button"
                className="button"
                disabled={lacks}
                aria-label={t.save(t.body[name], "STL")}
                onClick={() => save(name, body)}
              >
                <Icon name="download" /> STL
              </button>
            </li>
          );
        })}
      </ul>
      <p className="small soft">{t.bodiesHint}</p>
      {run.plane.length > 0 && run.steps.length > 0 && <Message tone="warning">{t.milling}</Message>}
      {run.unproved.length > 0 && <Message tone="warning">{t.unproved}</Message>}
    </section>
  );
}

const ALL = "all";

function Contours({ words: t, outcome: { run }, stem, say }: Part) {
  const group = useId(),
    lengths = useLengths(),
    contours = useMemo(() => contoursOf(run), [run]);
  const together = drawnTogether(contours);
  const [chosen, choose] = useState<string>(together ? ALL : "0"),
    [diameters, setDiameters] = useState(false);
  if (contours.length === 0) {
    return (
      <section aria-label={t.contour}>
        <h3>{t.contour}</h3>
        <p className="soft">{t.lack.noContour}</p>
      </section>
    );
  }
  const isChosen = (_: unknown, i: number) => chosen === ALL || chosen === String(i);
  const layers = layersOf(contours).filter(isChosen),
    isTurned = contours.find(isChosen)?.plane === "ZX";
  const own = contours.length > 1 && chosen !== ALL ? `${stem}_${Number(chosen) + 1}` : stem;
  const save = (text: string, ending: string) => {
    say(t.savedFile(downloadText(text, `${own}.${ending}`)));
  };
  const name = ({ block, cycle }: OfferedContour) =>
    cycle === null ? t.milled(String(block)) : t.one(String(block), String(cycle));
  return (
    <section aria-label={t.contour}>
      <h3>{t.contour}</h3>
      {contours.length > 1 && (
        <label>
          <span>{t.which}</span>
          <select className="select" value={chosen} onChange={(event) => choose(event.target.value)}>
            {together && <option value={ALL}>{t.all}</option>}
            {contours.map((each, i) => (
              <option key={i} value={i}>
                {name(each)}
              </option>
            ))}
          </select>
        </label>
      )}
      {isTurned && (
        <fieldset>
          <legend>{t.across}</legend>
          {([false, true] as const).map((each) => (
            <label key={String(each)}>
              <input type="radio" name={group} checked={diameters === each} onChange={() => setDiameters(each)} />
              {each ? t.diameter(`${lengths.number(DXF_CHORD)} ${lengths.unit}`) : t.radius}
            </label>
          ))}
        </fieldset>
      )}
      <p className="small soft">{isTurned ? `${t.acrossHint} ${t.svgHint}` : t.planeHint}</p>
      <div className="export-ways">
        <button
          type="button"
          className="button"
          aria-label={t.save(t.contour, "DXF")}
          onClick={() => save(writeDxf(layers, isTurned && diameters, run.program.unit), "dxf")}
        >
          <Icon name="download" /> DXF
        </button>
        <button
          type="button"
          className="button"
          aria-label={t.save(t.contour, "SVG")}
          onClick={() => save(contourSvg(layers) ?? "", "svg")}
        >
          <Icon name="download" /> SVG
        </button>
      </div>
    </section>
  );
}
