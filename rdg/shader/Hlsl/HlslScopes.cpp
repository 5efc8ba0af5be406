// Scopes: enters what is declared by name, and finds names in blocks, structs with bases, namespaces and the file.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

FNameScope* FAnalyser::MakeScope(EScopeKind Kind, FNameScope* Parent, const std::string& Name)
{
	FNameScope& Scope = Scopes.emplace_back();
	Scope.Kind = Kind;
	Scope.Parent = Parent;
	Scope.Prefix = Parent ? Parent->Prefix : std::string();
	Scope.Prefix += Name.empty() ? Name : Name + "::";
	Scope.Function = Parent ? Parent->Function : nullptr;
	return &Scope;
}

std::string_view FAnalyser::Keep(const std::string& Text)
{
	return Texts.emplace_back(Text);
}

void FAnalyser::EnterAll(const std::vector<FDeclaration*>& Declarations, FNameScope& Scope, const FDeclaration* Buffer)
{
	for (const FDeclaration* Declaration : Declarations)
	{
		EnterOne(*Declaration, Scope, Buffer);
	}
}

void FAnalyser::EnterOne(const FDeclaration& Declaration, FNameScope& Scope, const FDeclaration* Buffer)
{
	if (Scope.Kind == EScopeKind::File || Scope.Kind == EScopeKind::Namespace)
	{
		++NumDeclarations;
	}
	switch (Declaration.Kind)
	{
	case EDeclaration::Variable:
	{
		EnterType(Declaration.Type, Scope);
		if (Declaration.Name.Parts.size() > 1)
		{
			Outside.emplace_back(&Declaration, &Scope);
			break;
		}
		if (Declaration.Name.Last().empty())
		{
			break; // bits without a name
		}
		const bool bField = Scope.Kind == EScopeKind::Struct && !(Declaration.Modifiers & ModifierStatic);
		if (FSymbol* const Symbol =
				Add(Scope, Declaration.Name.Last(), bField ? ESymbol::Field : ESymbol::Variable, Declaration.Place))
		{
			Symbol->Declaration = &Declaration;
			Symbol->Buffer = Buffer;
			Symbol->Index = bField ? Scope.NumFields++ : 0;
		}
		break;
	}
	case EDeclaration::Function:
		EnterFunction(Declaration, Scope);
		break;
	case EDeclaration::Struct:
		if (Declaration.Struct)
		{
			EnterStruct(*Declaration.Struct, &Declaration, Scope);
		}
		break;
	case EDeclaration::Enum:
		if (Declaration.Enum)
		{
			EnterEnum(*Declaration.Enum, Scope);
		}
		break;
	case EDeclaration::Typedef:
		EnterType(Declaration.Type, Scope);
		if (FSymbol* const Symbol = Add(Scope, Declaration.Name.Last(), ESymbol::Alias, Declaration.Place))
		{
			Symbol->Declaration = &Declaration;
		}
		break;
	case EDeclaration::Namespace:
		EnterNamespace(Declaration, Scope);
		break;
	case EDeclaration::Buffer:
		EnterAll(Declaration.Members, Scope, &Declaration);
		break;
	case EDeclaration::Assert:
		if (Scope.Kind != EScopeKind::Block)
		{
			Asserts.emplace_back(&Declaration, &Scope);
		}
		break;
	case EDeclaration::Using:
		Scope.Usings.push_back({&Declaration, Scope.Kind == EScopeKind::Block ? 0 : NumDeclarations});
		break;
	case EDeclaration::Pack:
		break;
	}
}

/** A struct or an enum that a variable's type defines. */
void FAnalyser::EnterType(const FTypeName* Type, FNameScope& Scope)
{
	if (Type && Type->Struct && !Type->Struct->Name.empty())
	{
		EnterStruct(*Type->Struct, nullptr, Scope);
	}
	else if (Type && Type->Enum)
	{
		EnterEnum(*Type->Enum, Scope);
	}
}

void FAnalyser::EnterStruct(const FStruct& Struct, const FDeclaration* Declaration, FNameScope& Scope)
{
	const auto Known = Scope.Symbols.find(Struct.Name);
	if (Known != Scope.Symbols.end() && Known->second.Kind == ESymbol::Struct)
	{
		FSymbol& Symbol = Known->second;
		const bool bOldEmpty = !Symbol.Struct || (Symbol.Struct->Members.empty() && Symbol.Struct->Bases.empty());
		if (Symbol.Struct == &Struct || (Struct.Members.empty() && Struct.Bases.empty()))
		{
			return; // of another variable of one declaration, or declared once more
		}
		if (Declaration && Declaration->bTemplate && !Declaration->Name.Parts.empty() &&
			Declaration->Name.Parts.back().bArguments)
		{
			Symbol.Special.push_back(Declaration);
		}
		else if (bOldEmpty)
		{
			Symbol.Struct = &Struct;
			Symbol.Declaration = Declaration;
			Symbol.Place = Struct.Place;
		}
		else
		{
			Redefine(Symbol, Struct.Place);
		}
		return;
	}
	if (FSymbol* const Symbol = Add(Scope, Struct.Name, ESymbol::Struct, Struct.Place))
	{
		if (Declaration && Declaration->bTemplate && Declaration->Name.Parts.back().bArguments)
		{
			Symbol->Special.push_back(Declaration); // of a template that is only declared
			return;
		}
		Symbol->Struct = &Struct;
		Symbol->Declaration = Declaration;
	}
}

void FAnalyser::EnterEnum(const FEnum& Enum, FNameScope& Scope)
{
	if (EnumsByTree.count({&Enum, &Scope}))
	{
		return;
	}
	const std::string_view Name = Enum.Name.empty() ? Keep("enum#" + std::to_string(EnumsByTree.size())) : Enum.Name;
	FSymbol* const Symbol = Add(Scope, Name, ESymbol::Enum, Enum.Place);
	if (!Symbol)
	{
		return;
	}
	Symbol->Enum = &Enum;
	EnumsByTree[{&Enum, &Scope}] = Symbol;
	Symbol->Inner = MakeScope(EScopeKind::Namespace, &Scope, std::string(Enum.Name));
	for (const FEnumerator& Each : Enum.Enumerators)
	{
		for (FNameScope* In : {Symbol->Inner, Enum.bScoped ? nullptr : &Scope})
		{
			if (FSymbol* const Enumerator = In ? Add(*In, Each.Name, ESymbol::Enumerator, Each.Place) : nullptr)
			{
				Enumerator->Owner = Symbol;
				Enumerator->Enum = &Enum;
			}
		}
	}
}

void FAnalyser::EnterFunction(const FDeclaration& Declaration, FNameScope& Scope)
{
	if (Declaration.Name.Parts.size() > 1)
	{
		Outside.emplace_back(&Declaration, &Scope);
		return;
	}
	const std::string_view Name =
		Declaration.Operator.empty() ? Declaration.Name.Last() : Keep("operator" + std::string(Declaration.Operator));
	if (!Declaration.Operator.empty() && !Scope.Struct)
	{
		Error(Declaration.Place, "overloading non-member '" + std::string(Name) +
									 "' is not allowed; make it a method of the struct on its left");
		return;
	}
	auto Known = Scope.Symbols.find(Name);
	if (Known == Scope.Symbols.end() || Known->second.Kind != ESymbol::Functions)
	{
		if (!Add(Scope, Name, ESymbol::Functions, Declaration.Place))
		{
			return;
		}
		Known = Scope.Symbols.find(Name);
	}
	FOverload& Overload = Overloads.emplace_back();
	Overload.Declaration = &Declaration;
	Overload.Scope = &Scope;
	Overload.Struct = Scope.Struct;
	Overload.Order = Scope.Struct ? 0 : NumDeclarations;
	Overload.BodyOrder = Overload.Order;
	const bool bSpecial = Declaration.bTemplate && Declaration.Template.empty();
	(bSpecial ? Known->second.Specializations : Known->second.Overloads).push_back(&Overload);
}

void FAnalyser::EnterNamespace(const FDeclaration& Declaration, FNameScope& Scope)
{
	FNameScope* Inner = &Scope;
	for (const FNamePart& Part : Declaration.Name.Parts)
	{
		FNameScope& Outer = *Inner;
		const auto Known = Outer.Symbols.find(Part.Text);
		FSymbol* const Symbol = Known != Outer.Symbols.end() && Known->second.Kind == ESymbol::Namespace
									? &Known->second
									: Add(Outer, Part.Text, ESymbol::Namespace, Part.Place);
		if (!Symbol)
		{
			return;
		}
		Inner = Symbol->Inner =
			Symbol->Inner ? Symbol->Inner : MakeScope(EScopeKind::Namespace, &Outer, std::string(Part.Text));
	}
	EnterAll(Declaration.Members, *Inner);
}

/** Methods and functions of namespaces whose bodies stand elsewhere. */
void FAnalyser::EnterOutside()
{
	for (const auto& [Declaration, Scope] : Outside)
	{
		FPosition Position;
		Position.Scope = Scope;
		Position.Order = NumDeclarations;
		const FPositionGuard Guard(*this, Position);
		FSymbol* const Template =
			Declaration->Name.Parts.size() == 2 ? FindName(Declaration->Name.Parts[0].Text) : nullptr;
		if (Template && Template->Kind == ESymbol::Struct && Template->Declaration && Template->Declaration->bTemplate)
		{
			Template->Outside.push_back(Declaration);
			continue;
		}
		if (Declaration->Kind == EDeclaration::Variable)
		{
			FSymbol* const Variable = FindQualified(Declaration->Name);
			if (Variable && Variable->Kind == ESymbol::Variable && Variable->Scope->Struct)
			{
				Variable->Definition = Declaration;
			}
			else
			{
				Error(Declaration->Place, "X3004: there is no static member '" + std::string(Declaration->Name.Last()) +
											  "' that is defined here");
			}
			continue;
		}
		FName Owner = Declaration->Name;
		const std::string_view Name =
			Declaration->Operator.empty() ? Owner.Last() : Keep("operator" + std::string(Declaration->Operator));
		Owner.Parts.pop_back();
		FSymbol* const Symbol = FindQualified(Owner);
		FNameScope* const Inner = Symbol ? FindScopeOf(*Symbol, Owner.Parts.back()) : nullptr;
		FSymbol* const Functions = Inner ? FindIn(*Inner, Name) : nullptr;
		if (!Functions || Functions->Kind != ESymbol::Functions)
		{
			Error(Declaration->Place, "X3004: '" + std::string(Owner.Last()) + "' declares no function '" +
										  std::string(Name) + "', which is defined here");
			continue;
		}
		FOverload& Overload = Overloads.emplace_back();
		Overload.Declaration = Declaration;
		Overload.Scope = Inner;
		Overload.Struct = Inner->Struct;
		Overload.Order = 0;
		Overload.BodyOrder = NumDeclarations;
		Functions->Overloads.push_back(&Overload);
	}
}

bool FAnalyser::Redefine(const FSymbol& Old, const FPlace& Place)
{
	const bool bFile = Old.Place.File != Place.File && Old.Place.File < Tree.Files.size();
	Error(Place, "X3003: redefinition of '" + std::string(Old.Name) + "', which line " +
					 std::to_string(Old.Place.Line) + (bFile ? " of " + Tree.Files[Old.Place.File] : "") + " declares");
	return false;
}

FSymbol* FAnalyser::Add(FNameScope& Scope, std::string_view Name, ESymbol Kind, const FPlace& Place)
{
	if (!Options.bFxcRules && IsNumberName(Name))
	{
		Error(Place, "X3000: '" + std::string(Name) + "' is a type; only by FXC's rules, variables may have its name");
	}
	const auto [Known, bNew] = Scope.Symbols.try_emplace(Name);
	FSymbol& Symbol = Known->second;
	if (!bNew && Symbol.bOfLoop)
	{
		Symbol = FSymbol();
	}
	else if (!bNew)
	{
		Redefine(Symbol, Place);
		return nullptr;
	}
	Symbol.Kind = Kind;
	Symbol.Name = Name;
	Symbol.Scope = &Scope;
	Symbol.Place = Place;
	Symbol.Order = Scope.Kind == EScopeKind::File || Scope.Kind == EScopeKind::Namespace ? NumDeclarations : 0;
	return &Symbol;
}

bool FAnalyser::IsVisible(const FSymbol& Symbol) const
{
	return Symbol.Order <= Here.Order || Symbol.Kind == ESymbol::Namespace;
}

FSymbol* FAnalyser::FindIn(FNameScope& Scope, std::string_view Name, FNameScope** Where)
{
	for (FNameScope* At = &Scope; At;)
	{
		const auto Found = At->Symbols.find(Name);
		if (Found != At->Symbols.end() && IsVisible(Found->second))
		{
			if (Where)
			{
				*Where = At;
			}
			return &Found->second;
		}
		if (FSymbol* const Used = At->Usings.empty() ? nullptr : FindUsed(*At, Name, Where))
		{
			return Used;
		}
		FStructInfo* const Struct = At->Struct;
		if (Struct && !Struct->Type && !Struct->bBusy && !Struct->Tree->Bases.empty())
		{
			CompleteStruct(*Struct, Struct->Tree->Place);
		}
		At = Struct && Struct->Base ? Struct->Base->Scope : nullptr;
	}
	return nullptr;
}

FSymbol* FAnalyser::FindUsed(FNameScope& Scope, std::string_view Name, FNameScope** Where)
{
	for (size_t i = 0; i < Scope.Usings.size(); ++i)
	{
		const FDeclaration& Declaration = *Scope.Usings[i].Declaration;
		const bool bNamespace = !Declaration.Text.empty();
		if (Scope.Usings[i].Order > Here.Order || (!bNamespace && Declaration.Name.Last() != Name))
		{
			continue;
		}
		if (!Scope.Usings[i].bResolved)
		{
			Scope.Usings[i].bResolved = true; // at first: it does not help to find itself
			FPosition Position = Here;
			Position.Scope = &Scope;
			const FPositionGuard Guard(*this, Position);
			FNameScope* Found = nullptr;
			Scope.Usings[i].Target = FindQualified(Declaration.Name, &Found);
			Scope.Usings[i].Where = Found;
		}
		FSymbol* Target = Scope.Usings[i].Target;
		if (bNamespace)
		{
			Target = Target && Target->Kind == ESymbol::Namespace ? FindIn(*Target->Inner, Name, Where) : nullptr;
		}
		else if (Target && Where)
		{
			*Where = Scope.Usings[i].Where;
		}
		if (Target)
		{
			return Target;
		}
	}
	return nullptr;
}

FSymbol* FAnalyser::FindName(std::string_view Name, FNameScope** Where)
{
	for (FNameScope* Scope = Here.Scope; Scope; Scope = Scope->Parent)
	{
		if (FSymbol* const Symbol = FindIn(*Scope, Name, Where))
		{
			return Symbol;
		}
	}
	return nullptr;
}

FSymbol* FAnalyser::FindQualified(const FName& Name, FNameScope** Where)
{
	FSymbol* Symbol = Name.bGlobal ? FindIn(*File, Name.Parts[0].Text, Where) : FindName(Name.Parts[0].Text, Where);
	for (size_t i = 1; i < Name.Parts.size() && Symbol; ++i)
	{
		FNameScope* const Scope = FindScopeOf(*Symbol, Name.Parts[i - 1]);
		Symbol = Scope ? FindIn(*Scope, Name.Parts[i].Text, Where) : nullptr;
	}
	return Symbol;
}

FNameScope* FAnalyser::FindScopeOf(const FSymbol& Symbol, const FNamePart& Part)
{
	if (Symbol.Kind == ESymbol::Namespace)
	{
		return Symbol.Inner;
	}
	if (Symbol.Kind == ESymbol::Enum)
	{
		return Symbol.Inner;
	}
	if (Symbol.Kind != ESymbol::Struct && Symbol.Kind != ESymbol::Alias && Symbol.Kind != ESymbol::Type)
	{
		return nullptr;
	}
	FSymbol& Mutable = const_cast<FSymbol&>(Symbol);
	if (Symbol.Info && Symbol.Info->bBusy)
	{
		return Symbol.Info->Scope; // within itself
	}
	const FType* const Type = FindSymbolType(Mutable, Part);
	if (Type->IsStruct())
	{
		return GetInfo(Type)->Scope;
	}
	return Type->IsEnum() ? static_cast<const FSymbol*>(Type->EnumKey)->Inner : nullptr;
}

/** For "did you mean". */
std::vector<std::string> FAnalyser::ListNames(bool bFunctions, bool bTypes) const
{
	std::vector<std::string> Names;
	for (const FNameScope* Scope = Here.Scope; Scope; Scope = Scope->Parent)
	{
		for (const auto& [Name, Symbol] : Scope->Symbols)
		{
			const bool bType = Symbol.Kind == ESymbol::Struct || Symbol.Kind == ESymbol::Enum ||
							   Symbol.Kind == ESymbol::Alias || Symbol.Kind == ESymbol::Type;
			const bool bFunction = Symbol.Kind == ESymbol::Functions;
			if (IsVisible(Symbol) && Name.find('#') == std::string_view::npos && !Name.starts_with("operator") &&
				bType == bTypes && (bTypes || bFunction == bFunctions))
			{
				Names.emplace_back(Name);
			}
		}
	}
	std::sort(Names.begin(), Names.end()); // the nearest must not go by chance
	return Names;
}

} // namespace Drydock::Hlsl
