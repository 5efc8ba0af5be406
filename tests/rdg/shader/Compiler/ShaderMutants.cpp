// Changes a shader's text in a few places, by a seed alone.
#include "ShaderMutants.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <random>
#include <utility>
#include <vector>

namespace Drydock::Test
{

namespace
{

struct FToken
{
	size_t Begin;
	size_t Size;
};

bool IsWord(char c)
{
	return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

class FMutator
{
public:
	FMutator(const std::string& InText, const std::string& InPath, uint32_t Seed)
		: Text(InText)
		, Path(InPath)
		, Random(Seed)
	{
	}

	FShaderMutant Run();

private:
	uint32_t Pick(size_t Count) { return uint32_t(Random() % std::max<size_t>(1, Count)); }
	void Split();
	FToken PickToken() { return Tokens.empty() ? FToken{0, 0} : Tokens[Pick(Tokens.size())]; }
	/** One that starts with a digit or with a letter; any where there is none. */
	FToken PickToken(bool bNumber);
	std::string Get(FToken Token) const { return Text.substr(Token.Begin, Token.Size); }
	void Replace(FToken Token, const std::string& With) { Text.replace(Token.Begin, Token.Size, With); }

	const char* DeleteToken();
	const char* DuplicateToken();
	const char* SwapTokens();
	const char* ReplaceToken();
	const char* ChangeNumber();
	const char* RenameIdentifier();
	const char* Unbalance();
	const char* DeleteLine();
	const char* DropInclude();
	const char* IncludeItself();
	const char* RandomBytes();
	const char* NestDeeply();
	const char* Cut();

	std::string Text;
	const std::string Path;
	std::mt19937 Random;
	std::vector<FToken> Tokens;
};

void FMutator::Split()
{
	Tokens.clear();
	for (size_t i = 0; i < Text.size();)
	{
		const size_t Begin = i;
		if (Text.compare(i, 2, "//") == 0)
		{
			i = std::min(Text.find('\n', i), Text.size());
			continue;
		}
		if (std::isspace(static_cast<unsigned char>(Text[i])))
		{
			++i;
			continue;
		}
		const bool bNumber = std::isdigit(static_cast<unsigned char>(Text[i])) != 0;
		const auto IsPart = [bNumber](char c)
		{
			return IsWord(c) || (bNumber && c == '.');
		};
		do
		{
			++i;
		} while (i < Text.size() && IsPart(Text[Begin]) && IsPart(Text[i]));
		Tokens.push_back({Begin, i - Begin});
	}
}

FToken FMutator::PickToken(bool bNumber)
{
	std::vector<FToken> Fitting;
	std::copy_if(Tokens.begin(), Tokens.end(), std::back_inserter(Fitting),
		[this, bNumber](FToken Token)
		{
			const char First = Text[Token.Begin];
			return IsWord(First) && bNumber == (std::isdigit(static_cast<unsigned char>(First)) != 0);
		});
	return Fitting.empty() ? PickToken() : Fitting[Pick(Fitting.size())];
}

const char* FMutator::DeleteToken()
{
	Replace(PickToken(), "");
	return "delete token";
}

const char* FMutator::DuplicateToken()
{
	const FToken Token = PickToken();
	Replace(Token, Get(Token) + " " + Get(Token));
	return "duplicate token";
}

const char* FMutator::SwapTokens()
{
	FToken A = PickToken();
	FToken B = PickToken();
	if (A.Begin > B.Begin)
	{
		std::swap(A, B);
	}
	const std::string First = Get(A);
	const std::string Second = Get(B);
	Replace(B, First);
	Replace(A, Second);
	return "swap tokens";
}

const char* FMutator::ReplaceToken()
{
	const std::string Other = Get(PickToken());
	Replace(PickToken(), Other);
	return "replace token";
}

const char* FMutator::ChangeNumber()
{
	static const std::array<const char*, 14> Numbers = {"0", "1", "-1", "2.5", "1e38", "1e-45", "4294967295",
		"-2147483648", "0.0f", "1000000", "0x7fffffff", "(0.0 / 0.0)", "99999999999999999999", "1e999"};
	Replace(PickToken(true), Numbers[Pick(Numbers.size())]);
	return "change number";
}

const char* FMutator::RenameIdentifier()
{
	const FToken Token = PickToken(false);
	Replace(Token, Get(Token) + "X");
	return "rename identifier";
}

const char* FMutator::Unbalance()
{
	static const std::array<const char*, 8> Parts = {"{", "}", "(", ")", "[", "]", "#if 1\n", "/*"};
	Text.insert(PickToken().Begin, Parts[Pick(Parts.size())]);
	return "unbalance";
}

const char* FMutator::DeleteLine()
{
	const size_t At = PickToken().Begin;
	const size_t Before = Text.rfind('\n', At);
	const size_t Begin = Before == std::string::npos ? 0 : Before + 1;
	Text.erase(Begin, std::min(Text.find('\n', At), Text.size()) - Begin);
	return "delete line";
}

const char* FMutator::DropInclude()
{
	const size_t At = Text.find("#include", Pick(2) ? 0 : Pick(Text.size()));
	if (At != std::string::npos)
	{
		Text.erase(At, std::min(Text.find('\n', At), Text.size()) - At);
	}
	return "drop include";
}

const char* FMutator::IncludeItself()
{
	const size_t End = Text.find('\n', Pick(Text.size()));
	Text.insert(End == std::string::npos ? Text.size() : End + 1, "#include \"" + Path + "\"\n");
	return "include itself";
}

const char* FMutator::RandomBytes()
{
	const size_t At = Pick(Text.size());
	for (size_t i = At; i < std::min(Text.size(), At + 1 + Pick(16)); ++i)
	{
		Text[i] = char(Pick(256));
	}
	return "random bytes";
}

const char* FMutator::NestDeeply()
{
	static const std::array<std::pair<const char*, const char*>, 4> Pairs = {
		{{"(", ")"}, {"{", "}"}, {"if (1) {", "}"}, {"for (int q = 0; q < 2; ++q) {", "}"}}};
	static const std::array<size_t, 4> Depths = {8, 150, 1000, 20000};
	const auto [Open, Close] = Pairs[Pick(Pairs.size())];
	const FToken Token = PickToken();
	const size_t Depth = Depths[Pick(Depths.size())];
	std::string Nested;
	for (size_t i = 0; i < Depth; ++i)
	{
		Nested += Open;
	}
	Nested += Get(Token);
	for (size_t i = 0; i < Depth; ++i)
	{
		Nested += Close;
	}
	Replace(Token, Nested);
	return "nest deeply";
}

const char* FMutator::Cut()
{
	Text.resize(Pick(Text.size()));
	return "cut";
}

FShaderMutant FMutator::Run()
{
	// What still compiles is worth more: tokens and numbers come up more often than the rest.
	using FChange = const char* (FMutator::*)();
	static constexpr std::array<FChange, 20> Changes = {&FMutator::DeleteToken, &FMutator::DuplicateToken,
		&FMutator::SwapTokens, &FMutator::ReplaceToken, &FMutator::ReplaceToken, &FMutator::ReplaceToken,
		&FMutator::ChangeNumber, &FMutator::ChangeNumber, &FMutator::ChangeNumber, &FMutator::ChangeNumber,
		&FMutator::ChangeNumber, &FMutator::DeleteLine, &FMutator::DeleteLine, &FMutator::RenameIdentifier,
		&FMutator::Unbalance, &FMutator::DropInclude, &FMutator::IncludeItself, &FMutator::RandomBytes,
		&FMutator::NestDeeply, &FMutator::Cut};
	std::string What;
	const uint32_t Count = 1 + Pick(8) / 6;
	for (uint32_t i = 0; i < Count; ++i)
	{
		Split();
		What += (i ? ", " : "") + std::string((this->*Changes[Pick(Changes.size())])());
	}
	return {Text, What};
}

} // namespace

FShaderMutant MutateShader(const std::string& Text, const std::string& Path, uint32_t Seed)
{
	return FMutator(Text, Path, Seed).Run();
}

} // namespace Drydock::Test
