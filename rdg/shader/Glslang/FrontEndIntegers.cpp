// Two sweeps over the words: one writes other operations, or adds one before; the other gives divisions their own back.
#include "FrontEndIntegers.h"

#include <initializer_list>
#include <map>
#include <utility>

namespace Drydock
{

namespace
{

constexpr size_t BoundWord = 3; // of the header: above all ids
constexpr unsigned int HidingOp = spv::OpBitFieldUExtract;

/** A remainder has the sign of the left side in HLSL (`-7 % 4` is -3). glslang writes OpSMod, whose results of
 * constants have that of the right. */
void CorrectRemainders(std::vector<unsigned int>& Words)
{
	ForEachInstruction(Words,
		[&Words](unsigned int Op, size_t First, unsigned int)
		{
			if (Op == spv::OpSMod)
			{
				Words[First] = (Words[First] & ~spv::OpCodeMask) | spv::OpSRem;
			}
		});
}

/** Copies a module and changes what its functions do with integers. */
class FIntegerPass
{
public:
	explicit FIntegerPass(const std::vector<unsigned int>& InWords)
		: Words(InWords)
		, Result(InWords.begin(), InWords.begin() + GModuleHeaderWords)
		, Bound(InWords[BoundWord])
	{
	}
	std::vector<unsigned int> Run();

private:
	struct FType
	{
		unsigned int Width = 0;
		unsigned int Element = 0; // of a vector, else 0
		unsigned int Count = 1;
	};

	void Learn(unsigned int Op, const unsigned int* I, unsigned int Count);
	bool MaskCount(unsigned int Op, const unsigned int* I);
	bool HideDivision(unsigned int Op, const unsigned int* I);
	/** A constant of an integer type, scalar or vector. */
	unsigned int GetConstant(unsigned int Type, unsigned int Number);
	static void Add(std::vector<unsigned int>& To, unsigned int Op, std::initializer_list<unsigned int> Operands)
	{
		To.push_back(static_cast<unsigned int>(Operands.size() + 1) << spv::WordCountShift | Op);
		To.insert(To.end(), Operands);
	}

	const std::vector<unsigned int>& Words;
	std::vector<unsigned int> Result;
	std::vector<unsigned int> Constants; // new ones, which go before the first function
	size_t Functions = 0;                // where that begins in Result
	unsigned int Bound = 0;
	std::map<unsigned int, FType> Types;
	std::map<unsigned int, unsigned int> TypeOf;                         // of constants and of what functions compute
	std::map<unsigned int, unsigned int> Small;                          // constants of one word
	std::map<std::pair<unsigned int, unsigned int>, unsigned int> Known; // new constants, by type and number
};

unsigned int FIntegerPass::GetConstant(unsigned int Type, unsigned int Number)
{
	const FType Of = Types[Type];
	const unsigned int Scalar = Of.Element == 0 ? 0 : GetConstant(Of.Element, Number);
	unsigned int& Id = Known[{Type, Number}];
	if (Id != 0)
	{
		return Id;
	}
	Id = Bound++;
	if (Of.Element == 0)
	{
		Of.Width > 32 ? Add(Constants, spv::OpConstant, {Type, Id, Number, 0})
					  : Add(Constants, spv::OpConstant, {Type, Id, Number});
		return Id;
	}
	Constants.push_back((3 + Of.Count) << spv::WordCountShift | spv::OpConstantComposite);
	Constants.insert(Constants.end(), {Type, Id});
	Constants.insert(Constants.end(), Of.Count, Scalar);
	return Id;
}

void FIntegerPass::Learn(unsigned int Op, const unsigned int* I, unsigned int Count)
{
	if (Op == spv::OpTypeInt)
	{
		Types[I[1]] = {I[2], 0, 1};
	}
	else if (Op == spv::OpTypeVector && Types.count(I[2]))
	{
		Types[I[1]] = {Types[I[2]].Width, I[2], I[3]};
	}
	else if (Op == spv::OpFunction && Functions == 0)
	{
		Functions = Result.size();
	}
	if (Count > 2 && Types.count(I[1]))
	{
		TypeOf[I[2]] = I[1];
	}
	if (Op == spv::OpConstant && Count == 4)
	{
		Small[I[2]] = I[3];
	}
}

/** A shift by a number takes its low 5 bits (6, 4 for integers of 64 and 16 bits) in HLSL. The optimiser makes 0 of
 * constants that are shifted by more: each count that is not a constant below the width goes through an `&` with width
 * - 1. */
bool FIntegerPass::MaskCount(unsigned int Op, const unsigned int* I)
{
	if (Op != spv::OpShiftLeftLogical && Op != spv::OpShiftRightLogical && Op != spv::OpShiftRightArithmetic)
	{
		return false;
	}
	const auto By = TypeOf.find(I[4]);
	const auto Number = Small.find(I[4]);
	const unsigned int Width = Types.count(I[1]) ? Types[I[1]].Width : 0;
	if (Width == 0 || By == TypeOf.end() || (Number != Small.end() && Number->second < Width))
	{
		return false;
	}
	const unsigned int Mask = GetConstant(By->second, Width - 1);
	const unsigned int Id = Bound++;
	Add(Result, spv::OpBitwiseAnd, {By->second, Id, I[4], Mask});
	Add(Result, Op, {I[1], I[2], I[3], Id});
	return true;
}

bool IsDivision(unsigned int Op)
{
	return Op == spv::OpSDiv || Op == spv::OpUDiv || Op == spv::OpSRem || Op == spv::OpUMod;
}

/** The optimiser makes 0 of what is divided by 0, and ends by a signal at the least number divided by -1. So it is
 * shown an operation that it knows nothing of and HLSL has no word for, with the division's number as a last operand.
 */
bool FIntegerPass::HideDivision(unsigned int Op, const unsigned int* I)
{
	if (!IsDivision(Op) || !Types.count(I[1]))
	{
		return false;
	}
	const auto Divisor = Small.find(I[4]);
	if (Divisor != Small.end() && Divisor->second != 0 && Divisor->second != ~0u)
	{
		return false;
	}
	const FType Type = Types[I[1]];
	const unsigned int Number = GetConstant(Type.Element == 0 ? I[1] : Type.Element, Op);
	Add(Result, HidingOp, {I[1], I[2], I[3], I[4], Number});
	return true;
}

std::vector<unsigned int> FIntegerPass::Run()
{
	ForEachInstruction(Words,
		[this](unsigned int Op, size_t First, unsigned int Count)
		{
			const unsigned int* const I = Words.data() + First;
			Learn(Op, I, Count);
			if (!MaskCount(Op, I) && !HideDivision(Op, I))
			{
				Result.insert(Result.end(), I, I + Count);
			}
		});
	Result.insert(Result.begin() + std::ptrdiff_t(Functions), Constants.begin(), Constants.end());
	Result[BoundWord] = Bound;
	return std::move(Result);
}

} // namespace

void CorrectIntegers(std::vector<unsigned int>& Words)
{
	CorrectRemainders(Words);
	Words = FIntegerPass(Words).Run();
}

void RestoreDivisions(std::vector<unsigned int>& Words)
{
	std::map<unsigned int, unsigned int> Numbers;
	std::vector<unsigned int> Result(Words.begin(), Words.begin() + GModuleHeaderWords);
	ForEachInstruction(Words,
		[&](unsigned int Op, size_t First, unsigned int Count)
		{
			const unsigned int* const I = Words.data() + First;
			if (Op == spv::OpConstant)
			{
				Numbers[I[2]] = I[3];
			}
			const auto Hidden = Op == HidingOp ? Numbers.find(I[5]) : Numbers.end();
			if (Hidden == Numbers.end() || !IsDivision(Hidden->second))
			{
				Result.insert(Result.end(), I, I + Count);
				return;
			}
			Result.push_back(5u << spv::WordCountShift | Hidden->second);
			Result.insert(Result.end(), I + 1, I + 5);
		});
	Words = std::move(Result);
}

} // namespace Drydock
