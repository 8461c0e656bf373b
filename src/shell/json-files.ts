import { fetchOpenTaught } from "../features/course/index.ts";
import { fetchPartFiles } from "../features/plan/index.ts";

/** True for files of a finished part, of exercises or of results. */
export async function areTaughtFiles(files: readonly File[]): Promise<boolean> {
  const { findPartFile } = await fetchPartFiles();
  return (await findPartFile(files)) !== null || (await fetchOpenTaught()).areTaughtFiles(files);
}

/** Opens a finished part on the page of working plans, or exercises and results. */
export async function openTaughtFiles(files: readonly File[]): Promise<void> {
  const { findPartFile, openPartFile } = await fetchPartFiles();
  const part = await findPartFile(files);
  if (part) return openPartFile(part);
  return (await fetchOpenTaught()).openTaughtFiles(files);
}
