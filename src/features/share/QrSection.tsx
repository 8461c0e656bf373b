import { formatNumber } from "../../i18n/number.ts";
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
  if (!words) return null;
  const number = (n: number) => formatNumber(language, n);
  return (
    <section className="handing-code" aria-label={words.qr}>
      <h3>{words.qr}</h3>
      {link.length > LONGEST_QR ? (
        <p className="soft">{words.qrTooLong(number(link.length), number(LONGEST_QR))}</p>
      ) : (
        <>
          <QrCode link={link} name={words.qrName(name)} />
          {!isLocalAddress(pageAddress()) && <p className="small soft">{words.qrHint}</p>}
        </>
      )}
    </section>
  );
}
