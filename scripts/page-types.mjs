/**
 * `node scripts/page-types.mjs`: writes the types of the page objects to standard output as the text of one file that
 * needs only Playwright's own types, with its source files: `{ types, from }`. The classes come from the compiler;
 * types of the page that they use are copied, or expanded where they are computed from values.
 */
import { join } from "node:path";
import ts from "typescript";
import { root } from "./packages.mjs";

const ENTRY = join(root, "e2e", "pages", "index.ts");
const PAGES = join(root, "e2e", "pages");
const flags =
  ts.NodeBuilderFlags.NoTruncation |
  ts.NodeBuilderFlags.InTypeAlias |
  ts.NodeBuilderFlags.UseAliasDefinedOutsideCurrentScope;

const { config } = ts.readConfigFile(join(root, "tsconfig.base.json"), ts.sys.readFile);
const { options } = ts.parseJsonConfigFileContent(config, ts.sys, root);
const program = ts.createProgram([ENTRY], {
  ...options,
  composite: false,
  incremental: false,
  tsBuildInfoFile: undefined,
  declaration: true,
  emitDeclarationOnly: true,
});
const checker = program.getTypeChecker();
const printer = ts.createPrinter();
const isOurs = (file) => file.fileName.startsWith(join(root, "src")) || file.fileName.startsWith(join(root, "e2e"));

/** Types that would pull in the kernel, and that no test of the page needs in full. */
const PLAIN = { Sentences: "Readonly<Record<string, unknown>>" };

/** The symbol behind an import or a re-export. */
const meant = (symbol) => (symbol && symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol);

/** Declarations that the file must contain, by name, in the order of first use. */
const held = new Map();

/** Records the types of this project that a declaration uses. */
function follow(node) {
  const named = ts.isTypeReferenceNode(node)
    ? node.typeName
    : ts.isExpressionWithTypeArguments(node)
      ? node.expression
      : null;
  if (named && ts.isIdentifier(named)) {
    const symbol = meant(named.symbol ?? checker.getSymbolAtLocation(named));
    const [declaration] = symbol?.declarations ?? [];
    if (declaration && isOurs(declaration.getSourceFile()) && !ts.isTypeParameterDeclaration(declaration))
      take(symbol, declaration);
  }
  ts.forEachChild(node, follow);
}

/** Whether a type is computed from a value that this file does not have. */
function needsValues(node) {
  return ts.isTypeQueryNode(node) || (ts.forEachChild(node, (child) => needsValues(child) || undefined) ?? false);
}

/** Whether a type is a union of literals, which is clearer than its definition. */
const isList = (type) => type.isUnion() && type.types.every((each) => each.isLiteral());

function take(symbol, declaration) {
  if (ts.isClassDeclaration(declaration)) return;
  const { name } = symbol;
  if (held.has(name)) {
    if (held.get(name).declaration !== declaration)
      throw new Error(`Two types that page objects name are called ${name}.`);
    return;
  }
  const entry = { declaration, text: `type ${name} = ${PLAIN[name]};` };
  held.set(name, entry);
  if (PLAIN[name]) return;
  const type = checker.getDeclaredTypeOfSymbol(symbol);
  if (ts.isTypeAliasDeclaration(declaration) && (isList(type) || needsValues(declaration))) {
    const made = checker.typeToTypeNode(type, declaration, flags);
    entry.text = `type ${name} = ${printer.printNode(ts.EmitHint.Unspecified, made, declaration.getSourceFile())};`;
    follow(made);
    return;
  }
  entry.text = declaration
    .getFullText()
    .trim()
    .replace(/^export /m, "");
  follow(declaration);
}

const pages = program.getSourceFiles().filter((file) => file.fileName.startsWith(PAGES) && file.fileName !== ENTRY);
const shown = new Set(
  checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(ENTRY))).map((symbol) => symbol.name),
);
const classes = [];
const fromPlaywright = new Set();
for (const page of pages) {
  let text = "";
  program.emit(page, (_, made) => (text = made), undefined, true);
  const emitted = ts.createSourceFile(page.fileName, text, ts.ScriptTarget.Latest, true);
  for (const statement of emitted.statements) {
    if (ts.isImportDeclaration(statement)) {
      if (statement.moduleSpecifier.text === "@playwright/test") {
        for (const { name } of statement.importClause?.namedBindings?.elements ?? []) fromPlaywright.add(name.text);
      }
    } else if (ts.isClassDeclaration(statement) && shown.has(statement.name.text))
      classes.push(statement.getFullText().trim());
  }
  // Also from the files of the classes: types next to them, and imported types.
  for (const statement of page.statements) if (ts.isClassDeclaration(statement)) follow(statement);
}
const imports = [...fromPlaywright]
  .filter((name) => name !== "expect")
  .sort()
  .join(", ");
const types = [
  `// Page objects of Turnwise for Playwright; made by the build.\nimport type { ${imports} } from "@playwright/test";`,
  ...[...held].map(([name, { text }]) => (shown.has(name) ? text.replace(/^(?=interface|type)/m, "export ") : text)),
  ...classes,
  "export {};\n",
].join("\n\n");
const from = program
  .getSourceFiles()
  .filter(isOurs)
  .map(({ fileName }) => fileName);
process.stdout.write(JSON.stringify({ types, from }));
