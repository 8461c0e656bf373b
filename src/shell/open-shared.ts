import { isShareLink } from "../app/place/address.ts";
import { retryImport } from "../app/base/parts.ts";
import { notice } from "../app/base/notices.ts";
import { showIncoming } from "../app/records/incoming.ts";
import { fetchOpenTaught } from "../features/course/index.ts";

const PROBLEMS = { tooLarge: "linkTooLarge", newer: "linkNewer", damaged: "linkDamaged" } as const;

/**
 * Shows the content of a share link, once: it is then removed from the address. Nothing is opened before the operator
 * confirms, and the open work stays.
 */
export async function openShared(): Promise<void> {
  const { hash } = location;
  if (!isShareLink(hash)) return;
  history.replaceState(null, "", location.pathname + location.search);
  if (/^#[trs]\d/.test(hash)) return (await retryImport(fetchOpenTaught)).openTaughtLink(hash);
  const { readLink } = await retryImport(() => import("../app/records/link.ts"));
  const read = readLink(hash);
  if (read.kind === "work") showIncoming({ work: read.work, from: "link" });
  else notice(PROBLEMS[read.kind]);
}
