import { useState } from "react";
import { formatNumber } from "../../i18n/number.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { isLocalAddress, pageAddress } from "../../app/records/local-address.ts";
import { QrCode } from "./QrCode.tsx";
import { LONGEST_QR } from "./qr.ts";
import "./share.css";

/** The QR code of a link, or how much it is too long for one. `name`: what the link contains. */
export function QrSection({ link, name }: { readonly link: string; readonly name: string }) {
  const words = useTextsOrNull("handed");
  const language = useSettings((s) => s.language);
  const [isLarge, enlarge] = useState(false);
  if (!words) return null;
  const number = (n: number) => formatNumber(language, n);
  return (
    <section className="handing-code" aria-label={words.qr}>
      <h3>{words.qr}</h3>
      {link.length > LONGEST_QR ? (
        <p className="soft">{words.qrTooLong(number(link.length), number(LONGEST_QR))}</p>
      ) : (
        <>
          <button
            type="button"
            className="handing-enlarge"
            aria-haspopup="dialog"
            aria-label={words.qrEnlarge}
            title={words.qrEnlarge}
            onClick={() => enlarge(true)}
          >
            <QrCode link={link} name={words.qrName(name)} />
          </button>
          {!isLocalAddress(pageAddress()) && <p className="small soft">{words.qrHint}</p>}
          {isLarge && (
            <ModalDialog className="handing-full" title={words.qrName(name)} heading={name} done={() => enlarge(false)}>
              <QrCode link={link} name={words.qrName(name)} />
            </ModalDialog>
          )}
        </>
      )}
    </section>
  );
}
