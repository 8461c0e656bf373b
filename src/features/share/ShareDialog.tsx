import { useEffect, useState } from "react";
import type { HandedTexts } from "../../i18n/en/handed.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { ShownVerdict } from "../../app/findings/verdict.ts";
import { VerdictText } from "../../app/findings/VerdictText.tsx";
import { downloadBytes, downloadText } from "../../app/base/download.ts";
import { safeFileName } from "../../app/base/file-name.ts";
import { LONGEST_LINK, SAFE_LINK } from "../../app/base/limits.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import { copyText, useCopying } from "../../app/findings/copy.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { controlInUse, machineInUse } from "../../app/document/work-tools.ts";
import type { Work } from "../../app/document/work.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { linkOf } from "../../app/records/link.ts";
import { packWork, packedFile, type Packed } from "./pack.ts";
import { QrSection } from "./QrSection.tsx";
import { isLocalAddress, pageAddress } from "../../app/records/local-address.ts";
import { canShare, share } from "../../app/base/share-sheet.ts";
import { takeAnswer } from "../../app/base/until-gone.ts";
import { WorkFacts } from "./WorkFacts.tsx";
import "./share.css";

interface PackedWithLink extends Packed {
  /** Empty if it would be longer than browsers open. */
  readonly link: string;
}

/** The open work, packed as it was when the dialog opened; null until then. */
function usePacked(open: Work): PackedWithLink | null {
  const [ready, set] = useState<PackedWithLink | null>(null);
  useEffect(
    () =>
      takeAnswer(
        () => packWork(open),
        (made) => {
          const link = linkOf(pageAddress(), made.work);
          set({ ...made, link: link.length > LONGEST_LINK ? "" : link });
        },
      ),
    [open],
  );
  return ready;
}

interface Props {
  readonly open: Work;
  readonly verdict: ShownVerdict;
  readonly done: () => void;
}

/** The share dialog: link, QR code and files of the open work, with its tools, control and machine. */
export function ShareDialog({ open, verdict, done }: Props) {
  const words = useTextsOrNull("handed");
  const ready = usePacked(open);
  if (!words) return null;
  const tools = ready?.work.tools;
  return (
    <ModalDialog title={words.title} first=".modal-ways .primary" done={done}>
      <p>{words.lead}</p>
      <section className="handing-along" aria-label={words.contents}>
        <WorkFacts
          words={words}
          work={open}
          control={controlInUse()}
          machine={machineInUse()}
          tools={
            tools ? (
              tools.map(({ cells }) => words.tool(cells.T ?? "", cells.NAME ?? "")).join(", ") || words.none
            ) : (
              <span role="status" className="soft">
                {words.working}
              </span>
            )
          }
        />
        <VerdictText verdict={verdict} reasons={2} />
      </section>
      {ready && <ShareOptions words={words} ready={ready} />}
    </ModalDialog>
  );
}

/** Why the link may not open elsewhere; null if it does. */
function warningOf(words: HandedTexts, link: string, isOnlyHere: boolean): string | null {
  if (link === "") return words.linkTooLong;
  if (isOnlyHere) return words.hereOnly;
  return link.length > SAFE_LINK ? words.linkLong : null;
}

function ShareOptions({ words, ready }: { readonly words: HandedTexts; readonly ready: PackedWithLink }) {
  const t = useTexts().page;
  const language = useSettings((s) => s.language);
  const { work, file, link, report } = ready;
  const copied = useCopying((c) => c.state === "copied" && c.text === link);
  const stem = file.replace(/\.[^.]*$/, "");
  const archive = safeFileName(`${stem}.zip`);
  const isOnlyHere = isLocalAddress(pageAddress());
  const warning = warningOf(words, link, isOnlyHere);
  const sheet = {
    name: work.name,
    link: link.length > SAFE_LINK ? "" : link,
    file: () => new File([packedFile(ready)], archive, { type: "application/zip" }),
  };
  return (
    <>
      <section className="modal-link" aria-label={words.link}>
        <label>
          <span>
            {words.link} · <b className="number">{words.kilobytes(formatNumber(language, link.length / 1000, 1))}</b>
          </span>
          <textarea
            className="number"
            readOnly
            rows={3}
            value={link}
            onFocus={(event) => event.currentTarget.select()}
          />
        </label>
        {warning !== null && <Message tone="warning">{warning}</Message>}
        <div className="modal-ways">
          <button type="button" className="button primary" disabled={link === ""} onClick={() => void copyText(link)}>
            <Icon name={copied ? "check" : "copy"} /> {copied ? t.text.copied : words.copyLink}
          </button>
          {canShare(sheet) && (
            <button type="button" className="button" onClick={() => void share(sheet)}>
              {words.share}
            </button>
          )}
        </div>
      </section>
      {link !== "" && <QrSection link={link} name={work.name} />}
      <section aria-label={words.files}>
        <h3>{words.files}</h3>
        <div className="modal-ways">
          <button
            type="button"
            className="button"
            aria-label={`${words.file}: ${archive}`}
            onClick={() => downloadBytes(packedFile(ready), archive)}
          >
            <Icon name="download" /> {words.file}
          </button>
          {report !== null && (
            <button type="button" className="button" onClick={() => downloadText(report, `${stem}.report.json`)}>
              <Icon name="download" /> {words.report}
            </button>
          )}
        </div>
        <p className="small soft">{report === null ? words.noReport : words.reportHint}</p>
      </section>
    </>
  );
}
