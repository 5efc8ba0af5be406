// Follows the paths through a function, and which of its variables no statement has set on them.
#include "HlslUnset.h"

#include <algorithm>
#include <set>

namespace Drydock::Hlsl
{

namespace
{

using FUnsetVariables = std::set<const FVariable*>;

/** Arguments of what the language has that are written: those from First on. */
struct FUnsetWriter
{
	std::string_view Name;
	size_t First;
};

constexpr FUnsetWriter UnsetWriters[] = {{"sincos", 1}, {"modf", 1}, {"frexp", 1}, {"GetDimensions", 1}};

class FUnsetFinder
{
public:
	std::vector<std::pair<const FVariable*, FPlace>> Found;

	void Run(const FFunction& Function)
	{
		if (Function.Body)
		{
			RunCode(*Function.Body);
		}
	}

private:
	void Join(const FUnsetVariables& Other, bool bOtherEnds)
	{
		if (bEnds)
		{
			Unset = Other;
		}
		else if (!bOtherEnds)
		{
			Unset.insert(Other.begin(), Other.end());
		}
		bEnds = bEnds && bOtherEnds;
	}

	void RunAll(const std::vector<FCode*>& Codes)
	{
		for (const FCode* Code : Codes)
		{
			RunCode(*Code);
		}
	}

	void RunCode(const FCode& Code)
	{
		switch (Code.Kind)
		{
		case EStep::Block:
			RunAll(Code.Body);
			break;
		case EStep::Variable:
			Read(Code.Value);
			if (!Code.Value && !HasObject(Code.Variable->Type) && CountScalars(Code.Variable->Type) > 0)
			{
				Unset.insert(Code.Variable);
			}
			break;
		case EStep::Value:
			Read(Code.Value);
			break;
		case EStep::If:
			RunIf(Code);
			break;
		case EStep::Loop:
		case EStep::DoLoop:
			RunLoop(Code);
			break;
		case EStep::Switch:
			RunSwitch(Code);
			break;
		case EStep::Return:
			Read(Code.Value);
			bEnds = true;
			break;
		case EStep::Break:
			if (!bEnds)
			{
				Breaks.push_back(Unset);
			}
			bEnds = true;
			break;
		case EStep::Continue:
			bEnds = true;
			break;
		case EStep::Discard:
			break;
		}
	}

	void RunIf(const FCode& Code)
	{
		Read(Code.Value);
		const FUnsetVariables Before = Unset;
		const bool bBefore = bEnds;
		RunCode(*Code.Body[0]);
		const FUnsetVariables Then = Unset;
		const bool bThen = bEnds;
		Unset = Before;
		bEnds = bBefore;
		if (Code.Body.size() > 1)
		{
			RunCode(*Code.Body[1]);
		}
		Join(Then, bThen);
	}

	void RunLoop(const FCode& Code)
	{
		const bool bDo = Code.Kind == EStep::DoLoop;
		const size_t First = Breaks.size();
		if (!bDo && !Code.Body.empty())
		{
			RunCode(*Code.Body[0]);
		}
		if (!bDo)
		{
			Read(Code.Value);
		}
		const bool bBefore = bEnds;
		RunCode(*Code.Body.back());
		bEnds = bBefore; // a turn that is left by continue has a next one
		Read(bDo ? Code.Value : Code.Next);
		const bool bOnlyBreaks = !Code.Value && Breaks.size() > First;
		bEnds = bEnds || bOnlyBreaks;
		JoinBreaks(First);
	}

	void JoinBreaks(size_t First)
	{
		for (; Breaks.size() > First; Breaks.pop_back())
		{
			Join(Breaks.back(), false);
		}
	}

	void RunSwitch(const FCode& Code)
	{
		Read(Code.Value);
		const size_t First = Breaks.size();
		const FUnsetVariables Before = Unset;
		const bool bDefault = std::ranges::any_of(Code.Cases, [](const FCase& Each) { return Each.bDefault; });
		for (const FCase& Case : bEnds ? std::vector<FCase>() : Code.Cases)
		{
			Unset = Before;
			bEnds = false;
			RunAll(Case.Body);
			if (!bEnds)
			{
				Breaks.push_back(Unset);
			}
			bEnds = true;
		}
		if (!bDefault)
		{
			Unset = Before;
			bEnds = false;
		}
		JoinBreaks(First);
	}

	void Read(const FValue* Value)
	{
		if (!Value)
		{
			return;
		}
		switch (Value->Kind)
		{
		case EValue::Variable:
			if (!bEnds && Unset.erase(Value->Variable))
			{
				Found.emplace_back(Value->Variable, Value->Place);
			}
			break;
		case EValue::Assign:
			Read(Value->Operands[1]);
			Write(Value->Operands[0]);
			break;
		case EValue::And:
		case EValue::Or:
		case EValue::Choose:
			ReadChoice(*Value);
			break;
		case EValue::Call:
			ReadCall(*Value);
			break;
		case EValue::Intrinsic:
		case EValue::Method:
			ReadBuiltIn(*Value);
			break;
		default:
			for (const FValue* Operand : Value->Operands)
			{
				Read(Operand);
			}
			break;
		}
	}

	void ReadChoice(const FValue& Value)
	{
		Read(Value.Operands[0]);
		const FUnsetVariables Before = Unset;
		Read(Value.Operands[1]);
		const FUnsetVariables First = Unset;
		Unset = Before;
		if (Value.Operands.size() > 2)
		{
			Read(Value.Operands[2]);
		}
		Unset.insert(First.begin(), First.end());
	}

	void ReadCall(const FValue& Value)
	{
		const std::vector<FVariable*>& Parameters = Value.Function->Parameters;
		const auto IsOut = [&](size_t i)
		{
			return i < Parameters.size() &&
				   (Parameters[i]->Storage == EStorage::This || Parameters[i]->Modifiers & ModifierOut);
		};
		for (size_t i = 0; i < Value.Operands.size(); ++i)
		{
			const bool bThis = i < Parameters.size() && Parameters[i]->Storage == EStorage::This;
			if (!IsOut(i) || (Parameters[i]->Modifiers & ModifierIn && !bThis))
			{
				Read(Value.Operands[i]);
			}
		}
		for (size_t i = 0; i < Value.Operands.size(); ++i)
		{
			if (IsOut(i))
			{
				Write(Value.Operands[i]);
			}
		}
	}

	void ReadBuiltIn(const FValue& Value)
	{
		const auto Writer = std::ranges::find(UnsetWriters, Value.Name, &FUnsetWriter::Name);
		const bool bSplits = Value.Name == "asuint" && Value.Operands.size() == 3;
		const size_t First = bSplits                                 ? 1
							 : Value.Name.starts_with("Interlocked") ? 0
							 : Writer == std::end(UnsetWriters)      ? Value.Operands.size()
																	 : Writer->First;
		for (size_t i = 0; i < Value.Operands.size(); ++i)
		{
			i < First ? Read(Value.Operands[i]) : Write(Value.Operands[i]);
		}
	}

	/** Sets a variable, or a part of it: indices in it are read. */
	void Write(const FValue* Value)
	{
		switch (Value->Kind)
		{
		case EValue::Variable:
			Unset.erase(Value->Variable);
			break;
		case EValue::Index:
		case EValue::Element:
			Read(Value->Operands[1]);
			Write(Value->Operands[0]);
			break;
		case EValue::Member:
		case EValue::Swizzle:
		case EValue::Elements:
			Write(Value->Operands[0]);
			break;
		default:
			Read(Value);
			break;
		}
	}

	FUnsetVariables Unset;
	std::vector<FUnsetVariables> Breaks; // of the loops and switches around
	bool bEnds = false;                  // nothing goes on from here
};

} // namespace

std::vector<std::pair<const FVariable*, FPlace>> FindUnset(const FFunction& Function)
{
	FUnsetFinder Finder;
	Finder.Run(Function);
	return std::move(Finder.Found);
}

} // namespace Drydock::Hlsl
