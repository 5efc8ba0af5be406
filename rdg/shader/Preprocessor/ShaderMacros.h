// Tokens of a shader's text and the macros among them: definition and expansion by the rules of C (arguments expanded
// first, # and ##, __VA_ARGS__, a macro never inside its own expansion), which HLSL's preprocessor follows.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace Drydock
{

enum class EShaderToken : uint8_t
{
	Word,   // identifiers and keywords
	Number, // as the preprocessor sees it: "1.0f", "0x1F", "1.xxx"
	Quoted,
	Sign,  // operators and punctuation, the longest that fits
	Ended, // behind the last token of a macro's expansion; never leaves the expansion
};

struct FShaderToken
{
	EShaderToken Kind = EShaderToken::Sign;
	std::string Text;
	bool bSpaceBefore = false;
	bool bPainted = false; // the name of a macro, met inside its own expansion: stays as it is
};

using FShaderTokens = std::vector<FShaderToken>;

/** The most blank lines in a row of a text; `#line` skips further ones. */
inline constexpr int GMaxBlankLines = 6;

/** Tokens of a text without comments. */
DRYDOCK_API FShaderTokens SplitTokens(const std::string& Text);

/** Their text, with blanks where two would otherwise become one. */
DRYDOCK_API std::string JoinTokens(const FShaderTokens& Tokens);

struct FShaderMacro
{
	bool bFunction = false;
	bool bVariadic = false; // the last parameter takes all that is left
	std::vector<std::string> Parameters;
	FShaderTokens Body;
};

class DRYDOCK_API FShaderMacros
{
public:
	/** Defines a macro from the text behind #define: "NAME body" or "NAME(A, B) body". Returns the fault, or an empty
	 * text. A later definition of a name replaces the earlier one. */
	std::string Define(const std::string& Text);
	void Undefine(const std::string& Name) { Macros.erase(Name); }
	const FShaderMacro* Find(const std::string& Name) const
	{
		const auto Found = Macros.find(Name);
		return Found == Macros.end() ? nullptr : &Found->second;
	}

	/** Replaces every macro in Tokens. Problem becomes the first thing that is wrong (number of arguments, endless
	 * growth), and is left alone when nothing is. Unless bComplete, which means that no text follows, bNeedsMore
	 * becomes true when a call may go on in that text: the result is then of no use. */
	FShaderTokens Expand(const FShaderTokens& Tokens, bool bComplete, std::string& Problem, bool& bNeedsMore) const;

	/** Limits on the tokens that one call of Expand, and all calls together, may work on: a line whose call goes on in
	 * the next is expanded once more with each line, and a shader has many lines. */
	static constexpr size_t MaxLineTokens = 1u << 20;
	static constexpr size_t MaxTokens = 16u << 20;

	/** The work of all calls so far: tokens that were read, put in for a macro or looked through for the end of a call;
	 * a long token counts for several. */
	size_t GetNumTokens() const { return NumTokens; }
	bool IsSpent() const { return NumTokens > MaxTokens; }

private:
	std::map<std::string, FShaderMacro> Macros;
	mutable size_t NumTokens = 0; // an expansion changes nothing else
};

} // namespace Drydock
