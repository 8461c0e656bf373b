import type { ReactNode } from "react";
import { Working } from "../../calculation/Working.tsx";
import { PinnedCard } from "../../findings/effect/Pinned.tsx";
import type { FindingsHost } from "../../findings/host.ts";
import { FindingsHostContext } from "../../findings/host-context.ts";
import { useListed } from "../../findings/use-findings.ts";
import type { WorkKind, WorkSection } from "../../place/place.ts";
import { SectionTabs } from "../../place/SectionTabs.tsx";
import { Splitter } from "../../place/Splitter.tsx";
import { Centre, HelpDock } from "../dialog/HelpDock.tsx";
import { ConfirmExportDialog } from "../leaving/ConfirmExportDialog.tsx";
import { PrintedProgram } from "../program/PrintedProgram.tsx";

/** One section of the left column. */
export interface WorkTab {
  readonly section: WorkSection;
  readonly name: string;
  readonly content: ReactNode;
  /** Stays mounted while another section is open. */
  readonly stays?: boolean;
}

interface Props {
  readonly of: WorkKind;
  readonly host: FindingsHost;
  /** Name of the sections. */
  readonly name: string;
  readonly open: WorkSection;
  readonly sections: readonly WorkTab[];
  readonly strip: ReactNode;
  readonly picture: ReactNode;
  /** A drawing that is edited has the whole centre. */
  readonly isDrawing?: boolean;
  /** The column of the text; null where there is no room for it. */
  readonly text: ReactNode;
  readonly isFolded?: boolean;
  readonly children?: ReactNode;
}

/** The workplace of any work: its sections, the picture with the strip above, and the text. */
export function WorkColumns({
  of,
  host,
  name,
  open,
  sections,
  strip,
  picture,
  isDrawing = false,
  text,
  isFolded = false,
  children,
}: Props) {
  const findings = useListed();
  const layout = text === null ? " two-columns" : isFolded ? " program-folded" : "";
  return (
    <main className={`workplace${of === "program" ? " program-work" : ""}${layout}`}>
      <div className="left">
        <FindingsHostContext value={host}>
          <SectionTabs
            name={name}
            open={open}
            tabs={sections.map((each) => ({
              ...each,
              ...(each.section === "findings" && {
                badge: { count: findings.length, severity: findings[0]?.issue.severity ?? "info" },
              }),
            }))}
          />
        </FindingsHostContext>
      </div>
      <Splitter of={of} side="left" />
      {strip}
      <Centre>
        {picture}
        {!isDrawing && <HelpDock />}
        {!isDrawing && <PinnedCard />}
        <Working />
      </Centre>
      {text !== null && !isFolded && <Splitter of={of} side="right" />}
      {text !== null && <div className="right">{text}</div>}
      {children}
      <PrintedProgram />
      <ConfirmExportDialog cycleOf={host.cycleOf} />
    </main>
  );
}
