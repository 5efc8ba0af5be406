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

	/** Behind the > that closes the < at Open, where what lies between can be a list of types and numbers; else 0. A >>
	 * closes two. */
	size_t FindListEnd(size_t Open) const;

	/** Behind the statement that begins at At, with its attributes, its body and its else. */
	size_t FindStatementEnd(size_t At) const { return FindStatementEnd(At, 0); }

	/** The first token of the declaration at file scope whose braces At is in; Size() where it is in none. */
	size_t FindDeclaration(size_t At) const;

	/** The tokens [First, End) in one line. */
	std::string GetText(size_t First, size_t End) const;

	const FHlslToken& operator[](size_t At) const { return Tokens[At]; }
	size_t Size() const { return Tokens.size(); }
	bool Is(size_t At, const char* Sign) const { return At < Tokens.size() && Tokens[At].Is(Sign); }
	bool IsWord(size_t At) const { return At < Tokens.size() && Tokens[At].IsWord(); }

	/** After a change of Tokens: finds the brackets that belong together. */
	void Match();

	FHlslTokens Tokens;
	std::vector<std::string> Files; // virtual paths

private:
	size_t FindStatementEnd(size_t At, int Depth) const;

	std::vector<size_t> Closes; // of each token
};

/** Changes of a text, collected while it is read and made together. */
class DRYDOCK_API FHlslEdits
{
public:
	/** Words in place of the tokens [First, End), before First where there are none. Those at one place keep their
	 * order. */
	void Replace(size_t First, size_t End, const std::string& Words);
	void Insert(size_t Before, const std::string& Words) { Replace(Before, Before, Words); }
	void Move(size_t Before, FHlslTokens Moved);

	/** Behind the last token that is replaced: what begins before it waits for another round. */
	size_t GetEnd() const { return LastEnd; }
	bool IsEmpty() const { return Edits.empty(); }
	void Apply(FHlslText& Text);
	/** The same, with these declarations before the text; whether anything changed. */
	bool Apply(FHlslText& Text, const std::map<std::string, std::string>& Before);

private:
	struct FEdit
	{
		size_t First = 0;
		size_t End = 0;
		std::string Words;
		FHlslTokens Moved;
	};
	std::vector<FEdit> Edits;
	size_t LastEnd = 0;
};

/** Words as tokens that stand where Place does. */
DRYDOCK_API FHlslTokens MakeHlslTokens(const std::string& Words, const FHlslToken& Place);

} // namespace Drydock
