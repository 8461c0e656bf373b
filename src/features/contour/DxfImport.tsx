import { useMemo, useRef, useState } from "react";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import type { Language } from "../../i18n/languages.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { anyNumber, readText, type Field } from "../../program/values/field.ts";
import type { ContourRow } from "../../program/job/job.ts";
import { dxfDefaults, readDxf, type DxfChoice } from "../../program/dxf/read-dxf.ts";
import { contourDrawing } from "../../view/help/contour-drawing.ts";
import { NumberInput } from "../../app/fields/number/NumberInput.tsx";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { dxfText } from "./dxf-text.ts";
import { openDxf, type OpenedDxf } from "./open-dxf.ts";

interface Props {
  /** Number of elements in the table now. */
  readonly count: number;
  readonly language: Language;
  readonly onTake: (rows: readonly ContourRow[]) => void;
}

/** Gap tolerance of ends that meet, mm. */
const TOLERANCE: Field = { ...anyNumber, range: [0, 10], optional: false };
const SIZE = { width: 520, height: 260 };

/** A button that opens a drawing, and the dialog that imports it: choices, preview, faults. */
export function DxfImport({ count, language, onTake }: Props) {
  const t = texts(language).contour.dxf;
  const file = useRef<HTMLInputElement>(null),
    dialog = useRef<HTMLDialogElement>(null);
  const [opened, setOpened] = useState<OpenedDxf | null>(null);
  const [choice, setChoice] = useState<DxfChoice>(dxfDefaults);
  const [tolerance, setTolerance] = useState(String(dxfDefaults.tolerance));
  const fine = readText(TOLERANCE, tolerance).issue === null;
  const read = useMemo(() => (opened?.kind === "drawing" ? readDxf(opened.dxf, choice) : null), [opened, choice]);
  const reading = useMemo(() => (read ? readRows(read.rows) : null), [read]);
  const picture = useMemo(
    () =>
      reading &&
      contourDrawing({
        contour: reading.contour.segments,
        rowOfSegment: reading.rowOfSegment,
        ends: reading.rows.map((r) => r.end),
        faulty: new Set(),
        active: null,
        size: SIZE,
      }),
    [reading],
  );
  const change = (more: Partial<DxfChoice>) => setChoice((old) => ({ ...old, ...more }));
  const open = async (chosen: File | undefined) => {
    if (!chosen) return;
    setOpened(await openDxf(chosen));
    setChoice((old) => ({ ...old, chain: 0 }));
  };
  const close = () => dialog.current?.close();
  const tick = (name: string, key: "flipped" | "zeroRight" | "reversed") => (
    <label className="dxf-tick">
      <input type="checkbox" checked={choice[key]} onChange={(e) => change({ [key]: e.currentTarget.checked })} />{" "}
      <span>{name}</span>
    </label>
  );

  return (
    <>
      <button type="button" className="button contour-details" onClick={() => file.current?.click()}>
        {t.open}
      </button>
      <input
        ref={file}
        type="file"
        hidden
        accept=".dxf,image/vnd.dxf,application/dxf"
        aria-label={t.choose}
        onChange={(e) => {
          void open(e.currentTarget.files?.[0]);
          e.currentTarget.value = "";
        }}
      />
      {opened && (
        <ModalDialog
          isBare
          ref={dialog}
          className="dxf-import"
          first=".primary:not(:disabled)"
          title={t.title}
          done={() => setOpened(null)}
        >
          <h2>{t.title}</h2>
          <p className="soft">{opened.name}</p>
          {opened.kind !== "drawing" && (
            <Message role="alert" tone="error">
              {t[opened.kind]}
            </Message>
          )}
          {read && (
            <>
              <div className="contour-drawing dxf-preview">
                <svg role="img" aria-label={t.preview(read.rows.length)} viewBox={`0 0 ${SIZE.width} ${SIZE.height}`}>
                  <path className="axis" d={picture?.axis} />
                  {picture?.elements.map((e, i) => (
                    <path key={i} className="element" d={e.d} />
                  ))}
                  {picture?.points.slice(0, 1).map((p, i) => (
                    <circle key={i} className="dot first" cx={p.place.x} cy={p.place.y} r={5} />
                  ))}
                </svg>
              </div>
              <div className="dxf-choices">
                <label>
                  <span>{t.tolerance}</span>
                  <NumberInput
                    text={tolerance}
                    signed={false}
                    aria-invalid={!fine}
                    onText={(text) => {
                      const { value } = readText(TOLERANCE, text);
                      setTolerance(text);
                      if (value !== null) change({ tolerance: value, chain: 0 });
                    }}
                  />
                </label>
                <label>
                  <span>{t.axes}</span>
                  <select
                    className="select"
                    value={choice.swapped ? "swapped" : "straight"}
                    onChange={(e) => change({ swapped: e.currentTarget.value === "swapped" })}
                  >
                    <option value="straight">{t.straight}</option>
                    <option value="swapped">{t.swapped}</option>
                  </select>
                </label>
                <label>
                  <span>{t.measure}</span>
                  <select
                    className="select"
                    value={choice.diameters ? "diameter" : "radius"}
                    onChange={(e) => change({ diameters: e.currentTarget.value === "diameter" })}
                  >
                    <option value="radius">{t.radius}</option>
                    <option value="diameter">{t.diameter}</option>
                  </select>
                </label>
                {read.chains > 1 && (
                  <label>
                    <span>{t.chain}</span>
                    <select
                      className="select"
                      value={choice.chain}
                      onChange={(e) => change({ chain: Number(e.currentTarget.value) })}
                    >
                      {Array.from({ length: Math.min(read.chains, 50) }, (_, i) => (
                        <option key={i} value={i}>
                          {t.chainOf(i + 1, read.chains)}
                        </option>
                      ))}
                    </select>
                  </label>
                )}
                {tick(t.reversed, "reversed")}
                {tick(t.flipped, "flipped")}
                {tick(t.zeroRight, "zeroRight")}
              </div>
              {read.issues.length > 0 && (
                <ul className="dxf-notes" aria-label={t.found} aria-live="polite">
                  {read.issues.slice(0, 12).map((found, i) => (
                    <li key={i} className={`small ${found.severity}`}>
                      <Icon name={found.severity} /> <span>{dxfText(language, found)}</span>
                    </li>
                  ))}
                </ul>
              )}
              {count > 0 && <p className="small soft">{t.replaces(count)}</p>}
            </>
          )}
          <div className="dxf-buttons">
            <button type="button" className="button" onClick={() => file.current?.click()}>
              {t.choose}
            </button>
            <button type="button" className="button" onClick={close}>
              {t.cancel}
            </button>
            <button
              type="button"
              className="button primary"
              disabled={!read || read.rows.length < 2}
              onClick={() => {
                if (read) onTake(read.rows);
                close();
              }}
            >
              {t.take}
            </button>
          </div>
        </ModalDialog>
      )}
    </>
  );
}
