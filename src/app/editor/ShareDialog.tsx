import { useRef, useState } from "react";
import { formatNumber } from "../../i18n/number.ts";
import { Icon } from "../Icon.tsx";
import type { ShownVerdict } from "../findings/verdict.ts";
import { VerdictText } from "../findings/VerdictText.tsx";
import { mayLeave } from "../leaving/leaving.ts";
import { copyText, useCopying } from "../program/copy.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useEditor } from "../store.ts";
import { LONGEST_LINK } from "../files/limits.ts";
import { handOverText } from "./session.ts";
import { shareLink } from "./share.ts";

/** Links longer than this are cut by many programs, characters. */
const SAFE = 8000;

const pageAddress = () => location.href.replace(/[?#].*$/, "");

/** A button that makes a link of the program, with its length. */
export function ShareDialog() {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  const dialog = useRef<HTMLDialogElement>(null);
  const [link, setLink] = useState("");
  const [verdict, setVerdict] = useState<ShownVerdict | null>(null);
  const copied = useCopying((c) => c.state === "copied" && c.text === link);
  return (
    <>
      <button type="button" className="button" onClick={() => {
        handOverText();
        const { program } = useEditor.getState();
        if (!program) return;
        void mayLeave("share", program.text).then((allowed) => {
          if (!allowed) return;
          setVerdict(allowed);
          const made = shareLink(pageAddress(), program);
          setLink(made.length > LONGEST_LINK ? "" : made);
          dialog.current?.showModal();
        });
      }}>
        {t.editor.share}
      </button>
      <dialog ref={dialog} className="share-program" aria-label={t.editor.shareTitle}>
        <h2>{t.editor.shareTitle}</h2>
        <p>{t.editor.shareText}</p>
        <label>
          <span>
            {t.editor.shareLink} · <b className="number">{t.editor.shareSize(formatNumber(language, link.length / 1000, 1))}</b>
          </span>
          <textarea className="number" readOnly rows={5} value={link} onFocus={(event) => event.currentTarget.select()} />
        </label>
        {link === "" && (
          <p className="field-message warning">
            <Icon name="warning" /> {t.editor.shareTooLong}
          </p>
        )}
        {link.length > SAFE && (
          <p className="field-message warning">
            <Icon name="warning" /> {t.editor.shareLong}
          </p>
        )}
        {verdict && (
          <p>
            <VerdictText verdict={verdict} reasons={2} />
          </p>
        )}
        <div className="program-ways">
          <button type="button" className="button primary" disabled={link === ""} onClick={() => void copyText(link)}>
            <Icon name={copied ? "check" : "copy"} /> {copied ? t.page.text.copied : t.editor.copyLink}
          </button>
          <button type="button" className="button" onClick={() => dialog.current?.close()}>{t.page.close}</button>
        </div>
      </dialog>
    </>
  );
}
