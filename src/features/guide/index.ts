/* The guide and the glossary, and what prompts show of them. */

export const fetchGuidePage = () => import("./GuidePage.tsx");
export const fetchPromptMore = () => import("./PromptMore.tsx");
export const fetchSetupStart = () => import("./SetupStart.tsx");
