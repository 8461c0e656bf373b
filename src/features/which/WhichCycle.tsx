import { useMemo, useState } from "react";
import { comparison as byWorker } from "../../app/calculation/other-outcome.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { contourSlot } from "../../app/fields/slots.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import {
  REQUEST_FIELDS,
  changedRequest,
  numbersOn,
  readOperationRequest,
  operationRequestAt,
  usualNumbers,
  type AskedMeasure,
  type OperationRequest,
} from "../../app/document/operation-request.ts";
import type { WhichRegion } from "../../app/place/place.ts";
import type { Comparer } from "../../app/calculation/comparison.ts";
import { ShapeQuestion } from "./ShapeQuestion.tsx";
import { ShapeSketch } from "./ShapeSketch.tsx";
import { ContourSection } from "./ContourSection.tsx";
import { applyProposal } from "./apply-proposal.ts";
import { useComparison } from "./use-comparison.ts";
import { ProposalCards } from "./ProposalCards.tsx";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import "./which.css";

const ContourTable = lazyPart(async () => ({ default: (await contourSlot.fetch()).ContourTable }));

interface Props {
  readonly done: () => void;
  /** The region of an open work that is asked about; null for a question without a work. */
  readonly region: WhichRegion | null;
  /** The operation of the open program behind which a proposal is inserted; null: in front of all. */
  readonly behind?: number | null;
  readonly comparison?: Comparer;
}

function initialQuestion(region: WhichRegion | null): OperationRequest {
  if (!region)
    return { site: "outside", shape: "step", stock: "solid", typed: usualNumbers("outside", "step"), rows: [] };
  const { contour, site, stock, initialStock } = region;
  if (contour.length > 0) return operationRequestAt(region);
  return { site, shape: "step", stock: initialStock, typed: numbersOn(stock, site, "step"), rows: [] };
}

/** The part of the region with a contour to choose from. */
const sectionOf = (place: WhichRegion | null) => (place && place.contour.length > 0 ? place : null);

const ALL: ReadonlySet<AskedMeasure> = new Set(Object.keys(REQUEST_FIELDS) as AskedMeasure[]);
const NONE: ReadonlySet<AskedMeasure> = new Set();

/** Asks for the shape and compares the cycles that turn it. */
export function WhichCycle({ done, region, behind, comparison = byWorker }: Props) {
  const language = useSettings((s) => s.language);
  const words = useTextsOrNull("which");
  const [place, pick] = useState(region);
  const [asking, ask] = useState(() => initialQuestion(region));
  const [typed, type] = useState<ReadonlySet<AskedMeasure>>(() => (sectionOf(region) ? ALL : NONE));
  const { wanted, fault } = useMemo(() => readOperationRequest(asking), [asking]);
  const section = sectionOf(place);
  const stock = asking.stock === "now" ? (place?.stock ?? null) : null;
  const compared = useComparison(wanted, stock, comparison);

  const onAsk = (change: Partial<OperationRequest>) => {
    const { typed: now } = change;
    if (now) type((known) => new Set([...known, ...[...ALL].filter((m) => now[m] !== asking.typed[m])]));
    const usual = place ? numbersOn.bind(null, place.stock) : usualNumbers;
    ask((before) => changedRequest(before, change, typed, usual));
  };
  const adds = asking.stock === "now" || behind !== undefined;
  if (!words) return null;
  return (
    <ModalDialog className="modal which" title={words.title} first=".which-choice" done={done}>
      <p className="soft">{words.lead}</p>
      <ShapeQuestion words={words} asking={asking} fault={fault} inWork={place !== null} onAsk={onAsk} />
      <div className="which-pictures">
        {wanted && (!section || asking.shape !== "free") && <ShapeSketch words={words} wanted={wanted} />}
        {section && (
          <ContourSection
            words={words}
            contour={section.contour}
            first={section.first}
            last={section.last}
            onPick={(first, last) => {
              const next = { ...section, first, last };
              pick(next);
              const { rows, typed, shape } = operationRequestAt(next);
              onAsk({ rows, typed, shape });
            }}
          />
        )}
      </div>
      {asking.shape === "free" && !section && (
        <ContourTable rows={asking.rows} onChange={(rows) => onAsk({ rows })} language={language} />
      )}
      {fault?.at === "contour" && <p className="soft">{words.faults.contour}</p>}
      {compared && (
        <ProposalCards
          words={words}
          compared={compared}
          adds={adds}
          onTake={(way) => {
            done();
            void applyProposal(way, compared.wanted, { language, adds, behind });
          }}
        />
      )}
    </ModalDialog>
  );
}
