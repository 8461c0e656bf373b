import { useMemo } from "react";
import { qrOf, qrPath, QUIET } from "./qr.ts";

/** A link as a QR code, dark on light in both themes, as scanners expect; nothing for a link that is too long. */
export function QrCode({ link, name }: { readonly link: string; readonly name: string }) {
  const rows = useMemo(() => qrOf(link), [link]);
  if (!rows) return null;
  const size = rows.length + 2 * QUIET;
  return (
    <svg
      className="handing-qr"
      role="img"
      aria-label={name}
      viewBox={`0 0 ${size} ${size}`}
      shapeRendering="crispEdges"
    >
      <rect className="qr-light" width={size} height={size} />
      <path className="qr-dark" d={qrPath(rows)} />
    </svg>
  );
}
