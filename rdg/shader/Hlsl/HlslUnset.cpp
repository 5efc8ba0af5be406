// Follows the paths through a function, and which of its variables no statement has set on them.
#include "HlslUnset.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace Drydock::Hlsl
{

namespace
{

using FUnsetVariables = std::set<std::pair<const FVariable*, uint32_t>>; // with a member or component of it

uint32_t CountUnsetParts(const FType* Type)
{
	return Type->IsStruct()   ? std::max(1u, uint32_t(Type->Struct->Members.size()))
		   : Type->IsVector() ? Type->Columns
							  : 1u;
}

std::string NameUnsetPart(const FVariable& Variable, uint32_t Part)
{
	const FType* const Type = Variable.Type;
	return Variable.Name + (Type->IsStruct() && Part < Type->Struct->Members.size()
								   ? "." + Type->Struct->Members[Part].Name
							   : Type->IsVector() ? std::string(".") + "xyzw"[Part]
												  : "");
}

/** A variable, or members or components of one. */
struct FUnsetParts
{
	const FVariable* Variable = nullptr; // null: the value is something else
	std::vector<uint32_t> Parts;
};

FUnsetParts GetUnsetParts(const FValue& Value)
{
	if (Value.Kind == EValue::Variable)
	{
		FUnsetParts All{Value.Variable, std::vector<uint32_t>(CountUnsetParts(Value.Variable->Type))};
		std::iota(All.Parts.begin(), All.Parts.end(), 0);
		return All;
	}
	const FValue* const Of = Value.Operands.empty() ? nullptr : Value.Operands[0];
	if (!Of || Of->Kind != EValue::Variable)
	{
		return {};
	}
	if (Value.Kind == EValue::Member)
	{
		return {Of->Variable, {Value.Index}};
	}
	if (Value.Kind == EValue::Swizzle)
	{
		return {Of->Variable, {Value.Parts.begin(), Value.Parts.end()}};
	}
	const bool bComponent =
		Value.Kind == EValue::Index && Of->Type->IsVector() && Value.Operands[1]->Kind == EValue::Constant;
	return bComponent ? FUnsetParts{Of->Variable, {uint32_t(Value.Operands[1]->Constant.at(0))}} : FUnsetParts();
}

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
	std::vector<FUnset> Found;

	void Run(const FFunction& Function)
	{
		if (!Function.Body)
		{
			return;
		}
		for (const FVariable* Parameter : Function.Parameters)
		{
			if ((Parameter->Modifiers & (ModifierIn | ModifierOut)) == ModifierOut)
			{
				Outs.push_back(Parameter);
				Declare(*Parameter);
			}
		}
		RunCode(*Function.Body);
		CheckOuts();
	}

private:
	void Declare(const FVariable& Variable)
	{
		const uint32_t Count =
			HasObject(Variable.Type) || CountScalars(Variable.Type) == 0 ? 0 : CountUnsetParts(Variable.Type);
		for (uint32_t Part = 0; Part < Count; ++Part)
		{
			Unset.emplace(&Variable, Part);
		}
	}

	void CheckOuts()
	{
		for (const FVariable* Out : bEnds ? std::vector<const FVariable*>() : Outs)
		{
			const auto First = Unset.lower_bound({Out, 0});
			const auto IsOut = [Out](const FUnset& Known)
			{
				return Known.bOut && Known.Variable == Out;
			};
			if (First != Unset.end() && First->first == Out && std::ranges::none_of(Found, IsOut))
			{
				Found.push_back({Out, NameUnsetPart(*Out, First->second), Out->Place, true});
			}
		}
	}

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
			if (!Code.Value)
			{
				Declare(*Code.Variable);
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
			CheckOuts();
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
		if (const FUnsetParts Parts = GetUnsetParts(*Value); Parts.Variable)
		{
			ReadParts(Parts, Value->Place);
			return;
		}
		switch (Value->Kind)
		{
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

	void ReadParts(const FUnsetParts& Parts, const FPlace& Place)
	{
		const auto Part = std::ranges::find_if(Parts.Parts,
			[&](uint32_t Each) {
				return !bEnds && Unset.contains({Parts.Variable, Each});
			});
		if (Part != Parts.Parts.end())
		{
			Found.push_back({Parts.Variable, NameUnsetPart(*Parts.Variable, *Part), Place});
			std::erase_if(Unset, [&](const auto& Each) { return Each.first == Parts.Variable; });
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
		if (const FUnsetParts Parts = GetUnsetParts(*Value); Parts.Variable)
		{
			for (const uint32_t Part : Parts.Parts)
			{
				Unset.erase({Parts.Variable, Part});
			}
			return;
		}
		switch (Value->Kind)
		{
		case EValue::Index:
		case EValue::Element:
			Read(Value->Operands[1]);
			Write(Value->Operands[0]);
			break;
		case EValue::Member:
		case EValue::Bits:
		case EValue::Swizzle:
		case EValue::Elements:
			Write(Value->Operands[0]);
			break;
		default:
			Read(Value);
			break;
		}
	}

	std::vector<const FVariable*> Outs; // parameters
	FUnsetVariables Unset;
	std::vector<FUnsetVariables> Breaks; // of the loops and switches around
	bool bEnds = false;                  // nothing goes on from here
};

} // namespace

std::vector<FUnset> FindUnset(const FFunction& Function)
{
	FUnsetFinder Finder;
	Finder.Run(Function);
	return std::move(Finder.Found);
}

} // namespace Drydock::Hlsl
