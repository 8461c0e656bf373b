import { formatNumber } from "../../../i18n/number.ts";
import { LONGEST_LINK, SAFE_LINK } from "../../../app/base/limits.ts";
import { isLocalAddress, pageAddress } from "../../../app/records/local-address.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { copyText, useCopying } from "../../../app/findings/copy.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import "../../../app/base/modal.css";

/** A link to copy, with a warning if it may not open elsewhere. */
export function LinkBox({ link, copies }: { readonly link: string; readonly copies?: () => void }) {
  const t = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const copied = useCopying((c) => c.state === "copied" && c.text === link);
  const isHere = isLocalAddress(pageAddress()),
    isLong = link.length > SAFE_LINK;
  if (link.length > LONGEST_LINK) return <Message tone="warning">{t.linkLong}</Message>;
  return (
    <section className="modal-link" aria-label={t.link}>
      <label>
        <span>
          {t.link} · <b className="number">{t.kilobytes(formatNumber(language, link.length / 1000, 1))}</b>
        </span>
        <textarea className="number" readOnly rows={2} value={link} onFocus={(event) => event.currentTarget.select()} />
      </label>
      {(isHere || isLong) && <Message tone="warning">{isHere ? t.hereOnly : t.linkLong}</Message>}
      <div className="modal-ways">
        <button
          type="button"
          className="button primary"
          onClick={() => {
            copies?.();
            void copyText(link);
          }}
        >
          <Icon name={copied ? "check" : "copy"} /> {copied ? t.copied : t.copyLink}
        </button>
      </div>
    </section>
  );
}
