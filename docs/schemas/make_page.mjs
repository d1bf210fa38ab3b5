// Writes docs/json.md, every key of every JSON document, from the schemas in this folder.
//
//   node docs/schemas/make_page.mjs
//
// A description ends with its unit in brackets: "Advance at 90 deg. [m]". What is missing is refused.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { argv } from 'node:process';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const made = join(here, '../json.md');

const HEAD = `# JSON

Made by \`node docs/schemas/make_page.mjs\` from the schemas in [docs/schemas](schemas): change those, not this page.

\`--json\` prints one document on stdout, and nothing else. Its first key, \`schema\`, says which document it is; the number behind the stroke
grows when a key goes or changes its meaning. Keys may be added without that. Numbers have full double precision. What is not known is \`null\`: there is no NaN and no Infinity.

Units and signs are told for every key. Where nothing else is said: seconds, metres, radians; rudder angles positive to port;
yaw rates, sway and headings positive to starboard ([axes and signs](notation.md)). \`-\` is a pure number, U the speed, L the length of the ship. \`a.b\` is key
b of the object a, \`a[].b\` that of each object of the list a, \`a.*\` any key of a. A key with *may be missing* is not in every document.

\`ctest -R app.schemas\` holds documents of all commands against the schemas.
`;

/// Every schema by the name of its file.
export function schemas() {
  const files = readdirSync(here).filter((name) => name.endsWith('.json')).sort();
  return new Map(files.map((name) => [name, JSON.parse(readFileSync(join(here, name), 'utf8'))]));
}

/// The const of the key "schema" of its documents.
export function idOf(schema) {
  const form = schema.oneOf ? schema.$defs[nameOf(schema.oneOf[0].$ref)] : schema;
  return form.properties.schema.const;
}

const nameOf = (ref) => ref.split('/').at(-1);
const slug = (heading) => heading.toLowerCase().replace(/[^a-z0-9 _-]/g, '').replaceAll(' ', '-');
const headingOf = (definition, id) => `${definition} of ${id}`;
const commandOf = (schema) => /`swayaw ([^`]*)`/.exec(schema.description)[1];

// What is written of a $ref: a link to the table of what it stands for.
function link(ref, place) {
  const [file, definition] = ref.split('#/$defs/');
  const id = file ? idOf(place.all.get(file)) : place.id;
  return definition ? `[${definition}](#${slug(headingOf(definition, id))})` : `[${id}](#${slug(id)})`;
}

const WORDS = { number: 'number', integer: 'number', string: 'text', boolean: 'true or false', object: 'object', null: 'null' };

function typeOf(schema, place) {
  if (schema.$ref) return link(schema.$ref, place);
  if (schema.anyOf) return schema.anyOf.map((one) => typeOf(one, place)).join(' or ');
  if ('const' in schema) return `\`"${schema.const}"\``;
  if (schema.enum) return schema.enum.map((value) => (value === null ? 'null' : `\`"${value}"\``)).join(', ');
  const types = [schema.type].flat();
  return types.map((type) => (type === 'array' ? listOf(schema.items, place) : WORDS[type])).join(' or ').replace(/,$/, '');
}

function listOf(items, place) {
  return `list of ${typeOf(items, place).replace(/^(number|text|object|list)\b/, '$1s').replace(/ or null$/, ', some null,')}`;
}

const isNumber = (schema) => [schema.type].flat().some((type) => ['number', 'integer'].includes(type))
  || (schema.items !== undefined && isNumber(schema.items));

// Key, type, unit, meaning; where the schema is not complete its place is in `faults`.
function row(path, schema, place, always) {
  const told = schema.description ?? '';
  const [, meaning, unit] = /^(.*?)(?: \[([^\]]+)\])?$/.exec(told);  // "Advance at 90 deg.", "m"
  const where = `${place.id}: ${path}`;
  if (!/[.:]$/.test(meaning)) place.faults.push(`${where} has no description, or one without a full stop`);
  if (isNumber(schema) && !unit) place.faults.push(`${where} has no unit`);
  const cells = [`\`${path}\``, typeOf(schema, place) + (always ? '' : ', may be missing'), unit ?? '', meaning];
  return `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
}

// Rows of what is inside a key, without those of what it refers to.
function inside(path, schema, place) {
  if (schema.items) return inside(`${path}[]`, schema.items, place);
  const rows = schema.properties ? rowsOf(`${path}.`, schema, place) : [];
  const any = schema.additionalProperties;
  if (any && any.properties) rows.push(...rowsOf(`${path}.*.`, any, place));
  else if (any) rows.push(row(`${path}.*`, { ...any, description: anyWords(schema, any) }, place, true));
  return rows;
}

// Keys that are not known beforehand have the unit of the key that holds them.
function anyWords(schema, any) {
  const unit = / \[[^\]]+\]$/.exec(schema.description ?? '')?.[0] ?? (isNumber(any) ? ' [-]' : '');
  return `One of these.${unit}`;
}

function rowsOf(path, schema, place) {
  const required = schema.required ?? [];
  return Object.entries(schema.properties ?? {}).flatMap(([key, value]) => [
    row(path + key, value, place, required.includes(key)), ...inside(path + key, value, place)]);
}

function tableOf(schema, place) {
  const all = schema.$ref ? [`| all keys of | ${link(schema.$ref, place)} | | |`] : [];
  return ['| key | type | unit | meaning |', '| --- | --- | --- | --- |', ...all, ...rowsOf('', schema, place)].join('\n');
}

function sectionOf(file, schema, all, faults) {
  const place = { id: idOf(schema), all, faults };
  const forms = (schema.oneOf ?? []).map((form) => link(form.$ref, place)).join(' or ');
  const parts = [`## ${place.id}`, `${schema.title}. ${schema.description} Schema: [${file}](schemas/${file}).`];
  parts.push(forms ? `It has the keys of ${forms}.` : tableOf(schema, place));
  for (const [name, definition] of Object.entries(schema.$defs ?? {}))
    parts.push(`### ${headingOf(name, place.id)}`, definition.description, tableOf(definition, place));
  return parts.join('\n\n');
}

/// The whole page.
export function page() {
  const all = schemas(), faults = [];
  const sorted = [...all].sort(([, a], [, b]) => (commandOf(a) < commandOf(b) ? -1 : 1));
  const contents = sorted.map(([, schema]) => `| \`swayaw ${commandOf(schema)}\` | [${idOf(schema)}](#${slug(idOf(schema))}) |`);
  const sections = sorted.map(([file, schema]) => sectionOf(file, schema, all, faults));
  if (faults.length) throw new Error(faults.join('\n'));
  return `${[HEAD.trim(), ['| command | document |', '| --- | --- |', ...contents].join('\n'), ...sections].join('\n\n')}\n`;
}

if (argv[1] === fileURLToPath(import.meta.url)) writeFileSync(made, page());
