import { Suspense, useMemo, useState } from "react";
import { comparison as byWorker } from "../../app/calculation/beside.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { contourTableSlot } from "../../app/fields/slots.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTextsSoon } from "../../app/base/settings/use-texts.ts";
import { canBePreturned, readAsking, soughtAt, usualNumbers, type Sought } from "../../app/document/asking.ts";
import type { WhichRegion } from "../../app/place/place.ts";
import type { Comparer } from "../../app/calculation/comparison.ts";
import { Sentence } from "./Sentence.tsx";
import { ContourStretch } from "./ContourStretch.tsx";
import { takeWay } from "./take.ts";
import { useComparison } from "./use-comparison.ts";
import { WayCards } from "./WayCards.tsx";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import "./which.css";

const ContourTable = lazyPart(async () => ({ default: await contourTableSlot.fetch() }));

interface Props {
  readonly done: () => void;
  /** The region of an open work that is asked about; null for a question without a work. */
  readonly region: WhichRegion | null;
  readonly comparison?: Comparer;
}

function begun(region: WhichRegion | null): Sought {
  if (!region)
    return { site: "outside", shape: "step", stock: "solid", typed: usualNumbers("outside", "step"), rows: [] };
  return soughtAt(region);
}

/** A change of the question: until a number is typed, each shape starts with default numbers. */
function asked(before: Sought, change: Partial<Sought>, isTyped: boolean): Sought {
  const next = { ...before, ...change };
  const stock = next.stock === "preturned" && !canBePreturned(next.shape) ? "solid" : next.stock;
  const reshaped = change.site !== undefined || change.shape !== undefined;
  return { ...next, stock, typed: reshaped && !isTyped ? usualNumbers(next.site, next.shape) : next.typed };
}

/** Asks for the shape and compares the cycles that turn it. */
export function WhichCycle({ done, region, comparison = byWorker }: Props) {
  const language = useSettings((s) => s.language);
  const words = useTextsSoon("which");
  const [place, pick] = useState(region);
  const [asking, ask] = useState(() => begun(region));
  const [isTyped, type] = useState(false);
  const { wanted, fault } = useMemo(() => readAsking(asking), [asking]);
  const stock = asking.stock === "now" ? (place?.stock ?? null) : null;
  const compared = useComparison(wanted, stock, comparison);

  const onAsk = (change: Partial<Sought>) => {
    if (change.typed) type(true);
    ask((before) => asked(before, change, isTyped || region !== null));
  };
  return (
    <ModalDialog className="modal which" title={words?.title} done={done}>
      {words && (
        <>
          <p className="soft">{words.lead}</p>
          <Sentence words={words} asking={asking} fault={fault} inWork={place !== null} onAsk={onAsk} />
          {place && (
            <ContourStretch
              words={words}
              contour={place.contour}
              first={place.first}
              last={place.last}
              onPick={(first, last) => {
                const next = { ...place, first, last };
                pick(next);
                const { rows, typed, shape } = soughtAt(next);
                onAsk({ rows, typed, shape });
              }}
            />
          )}
          {asking.shape === "free" && !place && (
            <Suspense>
              <ContourTable rows={asking.rows} onChange={(rows) => onAsk({ rows })} language={language} />
            </Suspense>
          )}
          {fault?.at === "contour" && <p className="soft">{words.faults.contour}</p>}
          {compared && (
            <WayCards
              words={words}
              compared={compared}
              adds={asking.stock === "now"}
              onTake={(way) => {
                done();
                void takeWay(way, compared.wanted, { language, adds: asking.stock === "now" });
              }}
            />
          )}
        </>
      )}
    </ModalDialog>
  );
}
