import { formatNumber } from "../../../i18n/number.ts";
import { downloadText } from "../../../app/base/download.ts";
import { LONGEST_LINK, SAFE_LINK } from "../../../app/base/limits.ts";
import { lazyPart } from "../../../app/base/parts.ts";
import { canShare, share } from "../../../app/base/share-sheet.ts";
import { isLocalAddress, pageAddress } from "../../../app/records/local-address.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { Message } from "../../../app/base/Message.tsx";
import { copyText, useCopying } from "../../../app/findings/copy.ts";
import { qrSlot } from "../../../app/fields/slots.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import "../../../app/base/modal.css";

const QrSection = lazyPart(async () => ({ default: await qrSlot.fetch() }));

interface Props {
  readonly link: string;
  /** What is shared, for people and for its file. */
  readonly name: string;
  readonly file: { readonly name: string; readonly text: string; readonly label: string };
  /** Called before anything is shared. */
  readonly before?: () => void;
}

/** Ways to hand something on: link, QR code, share sheet and file, with a warning if the link may not open elsewhere. */
export function LinkBox({ link, name, file, before }: Props) {
  const t = useTexts("course-teach");
  const { share: shareWord } = useTexts("course-set");
  const language = useSettings((s) => s.language);
  const copied = useCopying((c) => c.state === "copied" && c.text === link);
  const isHere = isLocalAddress(pageAddress()),
    isTooLong = link.length > LONGEST_LINK,
    isLong = link.length > SAFE_LINK;
  // Share sheets pass on texts, but not JSON.
  const sheet = {
    name,
    link: isLong ? "" : link,
    file: () => new File([file.text], file.name.replace(/\.json$/, ".txt"), { type: "text/plain" }),
  };
  return (
    <>
      <section className="modal-link" aria-label={t.link}>
        {!isTooLong && (
          <label>
            <span>
              {t.link} · <b className="number">{t.kilobytes(formatNumber(language, link.length / 1000, 1))}</b>
            </span>
            <textarea
              className="number"
              readOnly
              rows={2}
              value={link}
              onFocus={(event) => event.currentTarget.select()}
            />
          </label>
        )}
        {(isHere || isLong) && <Message tone="warning">{isHere ? t.hereOnly : t.linkLong}</Message>}
        <div className="modal-ways">
          {!isTooLong && (
            <button
              type="button"
              className="button primary"
              onClick={() => {
                before?.();
                void copyText(link);
              }}
            >
              <Icon name={copied ? "check" : "copy"} /> {copied ? t.copied : t.copyLink}
            </button>
          )}
          <button
            type="button"
            className="button"
            onClick={() => {
              before?.();
              downloadText(file.text, file.name);
            }}
          >
            <Icon name="download" /> {file.label}
          </button>
          {canShare(sheet) && (
            <button
              type="button"
              className="button"
              onClick={() => {
                before?.();
                void share(sheet);
              }}
            >
              <Icon name="share" /> {shareWord}
            </button>
          )}
        </div>
      </section>
      {!isTooLong && <QrSection link={link} name={name} />}
    </>
  );
}
