// Text to syntax tree.
#pragma once

#include "Diagnostics.h"
#include "HlslTree.h"

namespace Drydock::Hlsl
{

/** The tokens of a preprocessed text: words, numbers, strings, signs and #pragma lines. `#line N "File"` sets the place
 * of what follows; VirtualPath is the file of what comes before the first. Files gets each file once. The tokens point
 * into Text. The last one is EToken::End. */
DRYDOCK_API std::vector<FToken> ReadTokens(const std::string& Text, const std::string& VirtualPath,
	std::vector<std::string>& Files, std::vector<FDiagnostic>& Errors);

/** A tree of the whole text. Errors: DD6010, each with file, line and column; the parser goes on behind the statement
 * or declaration in which one was found, so that one run reports all. A text nested more than MaxDepth levels is an
 * error. */
DRYDOCK_API FTree Parse(const std::string& Text, const std::string& VirtualPath, std::vector<FDiagnostic>& Errors);

inline constexpr int MaxDepth = 600;

/** Levels of one expression: `a + b + c` has three. */
inline constexpr uint32_t MaxHeight = 1024;

inline constexpr size_t MaxErrors = 20;

/** An error at a place: "FILE:LINE:COLUMN: error: MESSAGE". */
FDiagnostic MakeError(const std::vector<std::string>& Files, const FPlace& Place, const std::string& Message);

} // namespace Drydock::Hlsl
