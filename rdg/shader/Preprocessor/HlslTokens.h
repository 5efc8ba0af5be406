// Tokens of preprocessed HLSL that know their file and line. A rewrite can move them, and every line of the result
// still has its file and line.
#pragma once

#include "Diagnostics.h"
#include "ShaderMacros.h"

namespace Drydock
{

/** One token. A directive that the preprocessor left (#pragma) is one token with its whole line. */
struct FHlslToken : FShaderToken
{
	uint32_t File = 0; // index into FHlslText::Files
	int Line = 0;
	int Column = 0; // in the preprocessed line, 1-based

	bool Is(const char* Sign) const { return Text == Sign && Kind != EShaderToken::Quoted; }
	bool IsWord() const { return Kind == EShaderToken::Word; }
};

using FHlslTokens = std::vector<FHlslToken>;

/** A preprocessed text. */
struct DRYDOCK_API FHlslText
{
	/** Reads the text that FShaderPreprocessor gives; VirtualPath is the file of lines above the first `#line`. */
	FHlslText(const std::string& Text, const std::string& VirtualPath);

	/** The text of the tokens, with `#line` wherever the next token does not stand on the line that would follow. */
	std::string Join() const;

	/** The message about Tokens[At]; at the end of the text about the last one. */
	FDiagnostic MakeError(size_t At, const std::string& Message) const;

	/** The token that closes the (, [ or { at Open, or Tokens.size(); any other token closes itself. */
	size_t FindClose(size_t Open) const { return Open < Closes.size() ? Closes[Open] : Tokens.size(); }

	const FHlslToken& operator[](size_t At) const { return Tokens[At]; }
	size_t Size() const { return Tokens.size(); }
	bool Is(size_t At, const char* Sign) const { return At < Tokens.size() && Tokens[At].Is(Sign); }
	bool IsWord(size_t At) const { return At < Tokens.size() && Tokens[At].IsWord(); }

	/** After a change of Tokens: finds the brackets that belong together. */
	void Match();

	FHlslTokens Tokens;
	std::vector<std::string> Files; // virtual paths

private:
	std::vector<size_t> Closes; // of each token
};

} // namespace Drydock
